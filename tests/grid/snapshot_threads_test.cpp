// A writer publishes snapshots while readers look at them: what the window does with the solver.
#include "grid/tiled_field.hpp"

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace {

using pastoso::grid::kTileCells;
using pastoso::grid::Shape;
using pastoso::grid::TiledField;

constexpr Shape kShape{200, 130};

/// True when all values of all tiles are equal, as the writer leaves them.
bool is_even(const TiledField<int>& field) {
    const int expected = field.read(0)[0];
    for (int tile = 0; tile < field.tile_count(); ++tile) {
        const int* values = field.read(tile);
        for (int i = 0; i < kTileCells; ++i) {
            if (values[i] != expected) return false;
        }
    }
    return true;
}

void fill(TiledField<int>& field, int value) {
    for (int tile = 0; tile < field.tile_count(); ++tile)
        std::fill_n(field.write(tile), kTileCells, value);
}

TEST(SnapshotThreads, ReadersSeeWholeStatesWhileTheWriterGoesOn) {
    std::mutex mutex;
    TiledField<int> published(kShape);
    std::atomic<bool> done = false;
    std::atomic<int> torn = 0;

    const auto read = [&] {
        while (!done) {
            TiledField<int> snapshot;
            {
                const std::lock_guard lock(mutex);
                snapshot = published;
            }
            if (!is_even(snapshot)) ++torn;
        }
    };
    std::vector<std::thread> readers;
    for (int i = 0; i < 2; ++i)
        readers.emplace_back(read);

    TiledField<int> field(kShape);
    for (int version = 1; version <= 300; ++version) {
        fill(field, version);
        const std::lock_guard lock(mutex);
        published = field;
    }
    done = true;
    for (std::thread& reader : readers)
        reader.join();
    EXPECT_EQ(torn, 0);
    EXPECT_EQ(published.at(0, 0), 300);
}

TEST(SnapshotThreads, AWriterWaitsForNoReaderAndNeverWritesIntoASnapshot) {
    // The reader drops its snapshots at any moment; the writer then owns the tile and may write in
    // place.
    TiledField<int> field(kShape);
    fill(field, 0);
    for (int round = 1; round <= 300; ++round) {
        std::atomic<bool> even = false;
        std::thread reader([snapshot = field, &even, round]() mutable {
            even = is_even(snapshot) && snapshot.at(0, 0) == round - 1;
            snapshot = TiledField<int>();
        });
        fill(field, round);
        reader.join();
        EXPECT_TRUE(even) << "round " << round;
    }
}

}  // namespace

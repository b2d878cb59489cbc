// A good file with random damage either loads or is refused in a sentence; nothing else may happen.
#include "core/error.hpp"
#include "files/temporary_folder.hpp"
#include "project/archives.hpp"
#include "project/paintings.hpp"

#include <random>

#include <gtest/gtest.h>

namespace pastoso::project {
namespace {

class MutatedProject : public files::TemporaryFolder {
  protected:
    /// Whether it loads. Then it can be painted on.
    bool loads(std::span<const std::byte> bytes) {
        try {
            const LoadedProject project = parse_project(bytes, "it.pastoso", pool);
            document::Painting painting(project.painting, pool);
            painting.advance_tick();
            return true;
        } catch (const core::InputError& error) {
            EXPECT_EQ(std::string(error.what()).substr(0, 10), "it.pastoso");
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
            return false;
        }
    }
    core::ThreadPool pool{2};
    std::mt19937 random{20240521};
};

TEST_F(MutatedProject, BytesFlippedAndEndsCutOff) {
    const Bytes good = file_of(busy_project(pool), folder, pool);
    int refused = 0;
    for (int turn = 0; turn < 150; ++turn) {
        Bytes bad = good;
        for (unsigned flips = 1 + random() % 4; flips > 0; --flips)
            bad[random() % bad.size()] ^= static_cast<std::byte>(1U << (random() % 8));
        if (turn % 5 == 0) bad.resize(random() % bad.size());
        refused += loads(bad) ? 0 : 1;
    }
    // Most damage hits a picture for other programs, which nobody reads here.
    EXPECT_GT(refused, 30);
}

/// Past the archive's own checksums: the texts are changed and the archive made anew.
TEST_F(MutatedProject, TextsWithWrongLetters) {
    const Bytes good = file_of(busy_project(pool), folder, pool);
    int refused = 0;
    for (int turn = 0; turn < 200; ++turn) {
        const std::string entry = turn % 3 == 0 ? "pastoso/setup.json" : "pastoso/index.json";
        const Bytes bad = changed(good, entry, [&](std::string& text) {
            static constexpr char kLetters[] = "0123456789-.e[]{},:\"x";
            const std::size_t at = random() % text.size();
            if (random() % 3 == 0)
                text.erase(at, 1 + random() % 4);
            else
                text[at] = kLetters[random() % (sizeof kLetters - 1)];
        });
        refused += loads(bad) ? 0 : 1;
    }
    EXPECT_GT(refused, 100);
}

/// Past all checksums: what a tile may hold is all that stands between such a file and the solver.
TEST_F(MutatedProject, PaintOfRandomNumbers) {
    const Project good = busy_project(pool);
    for (int turn = 0; turn < 12; ++turn) {
        Project bad = good;
        film::FilmState& film = bad.painting.value.film;
        film.media.numbers.resize(2, film.media.numbers.front());
        for (int change = 0; change < 200; ++change) {
            const int x = static_cast<int>(random() % 180), y = static_cast<int>(random() % 90);
            film::PaintCell cell;
            for (std::int32_t& channel : cell)
                channel = static_cast<std::int32_t>(random() >> (1 + random() % 31));
            film.paint.set(x, y, cell);
            const auto thickness = static_cast<std::int32_t>(random() % film::kMaxThickness_quanta);
            film.thickness.set(x, y, thickness);
            film.lower.thickness.set(x, y, thickness / 3);
            for (std::int32_t& channel : cell)
                channel = thickness < 3 ? 0 : channel / 3;
            film.lower.paint.set(x, y, cell);
            film.worked.thickness.set(
                x, y, static_cast<std::int32_t>(random() % film::kMaxThickness_quanta));
            film.media.foreign.set(x, y, {0, thickness / 3});
            film.velocity_x.set(x, y, static_cast<float>(random() % 200001) - 1e5F);
        }
        EXPECT_TRUE(loads(unseen_file_of(bad, folder, pool)));
    }
}

}  // namespace
}  // namespace pastoso::project

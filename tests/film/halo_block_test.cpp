// What a tile sees of its neighbours, held to a plain lookup of each cell.
#include "film/explicit/halo_block.hpp"

#include "core/random.hpp"

#include <algorithm>
#include <memory>
#include <ostream>
#include <tuple>

#include <gtest/gtest.h>

namespace pastoso::film {

void PrintTo(Edge edge, std::ostream* out) {
    *out << (edge == Edge::Wall ? "wall" : edge == Edge::Open ? "open" : "periodic");
}

namespace {

using grid::kTileSize;

class HaloBlocks : public testing::TestWithParam<std::tuple<Edge, Edge>> {
  protected:
    void make_canvas(const grid::Shape& shape) {
        state = FilmState(shape, 0.25);
        for (int y = 0; y < shape.height; ++y)
            for (int x = 0; x < shape.width; ++x) {
                const auto noise = [&](std::uint32_t seed) {
                    return core::uniform_noise(static_cast<std::uint32_t>(x + 997 * y), seed);
                };
                state.thickness.set(x, y, static_cast<std::int32_t>(5000.0F * noise(1)));
                state.support_mm.set(x, y, noise(2));
                state.velocity_x.set(x, y, noise(3) - 0.5F);
                state.velocity_y.set(x, y, noise(4) - 0.5F);
            }
    }

    /// The cell that stands for one beyond the edge, and whether paint is there.
    struct Stand {
        int place;
        bool outside;
    };
    static Stand cell_for(int place, int count, Edge edge) {
        if (place >= 0 && place < count) return {place, false};
        if (edge == Edge::Periodic) return {(place + 64 * count) % count, false};
        const int mirrored = place < 0 ? -1 - place : 2 * count - 1 - place;
        return {std::clamp(mirrored, 0, count - 1), edge == Edge::Open};
    }

    float thickness(int x, int y) const {
        const Stand column = cell_for(x, state.shape.width, edge_x);
        const Stand row = cell_for(y, state.shape.height, edge_y);
        if (column.outside || row.outside) return 0.0F;
        return thickness_mm(state.thickness.at(column.place, row.place));
    }
    float support(int x, int y) const {
        return state.support_mm.at(cell_for(x, state.shape.width, edge_x).place,
                                   cell_for(y, state.shape.height, edge_y).place);
    }

    /// Of a component whose axis is first: faces at a wall or open edge hold none.
    struct Along {
        int place, count;
        Edge edge;
    };
    template <class At>
    static float velocity(const Along& along, const Along& across, const At& at) {
        const Stand line = cell_for(across.place, across.count, across.edge);
        if (line.outside) return 0.0F;
        if (along.edge == Edge::Periodic)
            return at(cell_for(along.place, along.count, along.edge).place, line.place);
        if (along.place >= 0 && along.place < along.count - 1) return at(along.place, line.place);
        if (along.edge == Edge::Open || along.place == -1 || along.place == along.count - 1) return 0.0F;
        const int mirrored = along.place < 0 ? -2 - along.place : 2 * along.count - 2 - along.place;
        return -at(std::clamp(mirrored, 0, along.count - 1), line.place);
    }
    float velocity_x(int x, int y) const {
        return velocity({x, state.shape.width, edge_x}, {y, state.shape.height, edge_y},
                        [&](int i, int j) { return state.velocity_x.at(i, j); });
    }
    float velocity_y(int x, int y) const {
        return velocity({y, state.shape.height, edge_y}, {x, state.shape.width, edge_x},
                        [&](int j, int i) { return state.velocity_y.at(i, j); });
    }

    /// They end beside the edge of a tile, and are smaller than the margin.
    static constexpr grid::Shape kCanvases[] = {{1, 2},   {3, 64},   {63, 67},  {66, 2},
                                                {66, 67}, {130, 64}, {130, 131}};

    const Edge edge_x = std::get<0>(GetParam()), edge_y = std::get<1>(GetParam());
    FilmState state;
};

TEST_P(HaloBlocks, HoldWhatLiesThereOrStandsForIt) {
    const auto block = std::make_unique<HaloBlock>();
    for (const grid::Shape& shape : kCanvases) {
        make_canvas(shape);
        for (int tile = 0; tile < shape.tile_count(); ++tile) {
            const int tile_x = tile % shape.tiles_x(), tile_y = tile / shape.tiles_x();
            const HaloMap columns = make_halo_map(tile_x, shape.width, edge_x);
            const HaloMap rows = make_halo_map(tile_y, shape.height, edge_y);
            gather(state, columns, rows, tile_x, 1e-4F, *block);
            for (int y = -kHalo; y < kTileSize + kHalo; ++y)
                for (int x = -kHalo; x < kTileSize + kHalo; ++x) {
                    const int i = block_index(x, y);
                    const int across = tile_x * kTileSize + x, down = tile_y * kTileSize + y;
                    const bool reached = x < columns.extent + kHalo && y < rows.extent + kHalo;
                    ASSERT_EQ(block->thickness[i], reached ? thickness(across, down) : 0.0F);
                    ASSERT_EQ(block->support[i], reached ? support(across, down) : 0.0F);
                    ASSERT_EQ(block->eta[i], block->thickness[i] + block->support[i]);
                    ASSERT_EQ(block->velocity_x[i], reached ? velocity_x(across, down) : 0.0F)
                        << across << ", " << down;
                    ASSERT_EQ(block->velocity_y[i], reached ? velocity_y(across, down) : 0.0F)
                        << across << ", " << down;
                }
        }
    }
}

TEST_P(HaloBlocks, OfQuantaAloneAreTheSame) {
    const auto block = std::make_unique<HaloBlock>();
    const auto quanta = std::make_unique<BlockArray<std::int32_t>>();
    for (const grid::Shape& shape : kCanvases) {
        make_canvas(shape);
        const HaloMap columns = make_halo_map(0, shape.width, edge_x);
        const HaloMap rows = make_halo_map(0, shape.height, edge_y);
        gather(state, columns, rows, 0, 1e-4F, *block);
        gather_quanta(state.thickness, columns, rows, 0, *quanta);
        EXPECT_EQ(*quanta, block->quanta);
    }
}

INSTANTIATE_TEST_SUITE_P(OfAllEdges, HaloBlocks,
                         testing::Combine(testing::Values(Edge::Wall, Edge::Open, Edge::Periodic),
                                          testing::Values(Edge::Wall, Edge::Open, Edge::Periodic)));

}  // namespace
}  // namespace pastoso::film

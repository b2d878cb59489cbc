#include "film/cell/structure.hpp"

#include "film/cell/tile_quanta.hpp"
#include "film/state.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace pastoso::film {
namespace {

using grid::kTileCells;
using Block = grid::TileBlock<std::int32_t>;

/// A smaller part of the cell's paint is too little to follow: 2^-14.
constexpr int kLeastShareBits = 14;

std::vector<int> worked_tiles(const WorkedPaint& worked) {
    std::vector<int> tiles;
    for (int tile = 0; tile < worked.thickness.tile_count(); ++tile)
        if (worked.is_in(tile)) tiles.push_back(tile);
    return tiles;
}

Block recovered(const std::int32_t* worked, const std::int32_t* thickness, float left) {
    auto block = Block::uninitialised();
    std::int32_t* out = block.write();
    for (int cell = 0; cell < kTileCells; ++cell) {
        const std::int32_t part = std::min(worked[cell], thickness[cell]);
        const auto rest = static_cast<std::int32_t>(static_cast<float>(part) * left);
        out[cell] = rest > thickness[cell] >> kLeastShareBits ? rest : 0;
    }
    return block;
}

}  // namespace

bool WorkedPaint::is_anywhere() const {
    for (int tile = 0; tile < thickness.tile_count(); ++tile)
        if (is_in(tile)) return true;
    return false;
}

bool WorkedPaint::holds_any(int tile) const {
    return is_in(tile) && any_quanta(thickness.read(tile));
}

void WorkedPaint::replace(int tile, Block worked) {
    if (any_quanta(worked.read()))
        thickness.replace(tile, std::move(worked));
    else
        thickness.reset(tile);
}

void WorkedPaint::follow(bool followed) {
    is_followed = followed;
    if (followed) return;
    for (int tile = 0; tile < thickness.tile_count(); ++tile)
        thickness.reset(tile);
}

void recover(FilmState& state, double seconds, double recovery_s, core::ThreadPool& pool) {
    const std::vector<int> tiles = worked_tiles(state.worked);
    const auto left = static_cast<float>(std::exp(-seconds / recovery_s));
    std::vector<Block> results(tiles.size());
    pool.run(tiles.size(), [&](std::size_t index, int) {
        const int tile = tiles[index];
        results[index] = recovered(state.worked.thickness.read(tile), state.thickness.read(tile), left);
    });
    for (std::size_t index = 0; index < tiles.size(); ++index)
        state.worked.replace(tiles[index], std::move(results[index]));
}

}  // namespace pastoso::film

#include "film/cell/structure.hpp"

#include "film/cell/tile_quanta.hpp"
#include "film/state.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace pastoso::film {
namespace {

using grid::kTileCells;
using Block = grid::TileBlock<std::int32_t>;

std::vector<int> worked_tiles(const WorkedPaint& worked) {
    std::vector<int> tiles;
    for (int tile = 0; tile < worked.thickness.tile_count(); ++tile)
        if (worked.is_in(tile)) tiles.push_back(tile);
    return tiles;
}

/// What rest leaves of a worked part in each cell, by the recovery time of its paint.
class Rest {
  public:
    Rest(const FilmState& state, int tile, double seconds)
        : state_(state), tile_(tile), seconds_(seconds) {
        if (!state.media.is_mixed(tile))
            in_all_ = left(state.media.numbers[state.media.own[tile]].recovery_s);
    }
    float operator()(int cell) const {
        return in_all_ ? *in_all_ : left(mixed_number(state_, tile_, cell, &FilmNumbers::recovery_s));
    }

  private:
    float left(double recovery_s) const { return static_cast<float>(std::exp(-seconds_ / recovery_s)); }

    const FilmState& state_;
    int tile_;
    double seconds_;
    std::optional<float> in_all_;
};

Block recovered(const std::int32_t* worked, const std::int32_t* thickness, const Rest& left) {
    auto block = Block::uninitialised();
    std::int32_t* out = block.write();
    for (int cell = 0; cell < kTileCells; ++cell) {
        const std::int32_t part = std::min(worked[cell], thickness[cell]);
        const auto rest = static_cast<std::int32_t>(static_cast<float>(part) * left(cell));
        out[cell] = rest > thickness[cell] >> kTraceBits ? rest : 0;
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

void recover(FilmState& state, double seconds, core::ThreadPool& pool) {
    const std::vector<int> tiles = worked_tiles(state.worked);
    std::vector<Block> results(tiles.size());
    pool.run(tiles.size(), [&](std::size_t index, int) {
        const int tile = tiles[index];
        results[index] = recovered(state.worked.thickness.read(tile), state.thickness.read(tile),
                                   Rest(state, tile, seconds));
    });
    for (std::size_t index = 0; index < tiles.size(); ++index)
        state.worked.replace(tiles[index], std::move(results[index]));
}

}  // namespace pastoso::film

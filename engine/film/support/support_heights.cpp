#include "film/support/support_heights.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pastoso::film {
namespace {

using grid::kTileCells;
using grid::TileBlock;

constexpr double kMostLevels = std::numeric_limits<std::uint16_t>::max();
/// Where the steps would be a millimetre wide.
constexpr double kHighestInLevels_mm = kMostLevels;

bool is_level(double height_mm, double level_mm) {
    const double levels = height_mm / level_mm;
    return levels >= 0.0F && levels <= kMostLevels && levels == std::floor(levels);
}

}  // namespace

double finest_level_mm(double highest_mm) {
    double level_mm = kSupportQuantum_mm;
    while (highest_mm > kMostLevels * level_mm)
        level_mm *= 2.0;
    return level_mm;
}

void TileHeights::copy(int cell, int count, float* out_mm) const {
    if (heights_mm != nullptr) {
        std::copy_n(heights_mm + cell, count, out_mm);
        return;
    }
    for (int i = 0; i < count; ++i)
        out_mm[i] = static_cast<float>(levels[cell + i]) * level_mm;
}

HeightBlock HeightBlock::smallest_of(TileBlock<float> heights_mm) {
    const float* heights = heights_mm.read();
    const double highest_mm = *std::max_element(heights, heights + kTileCells);
    if (!(highest_mm <= kHighestInLevels_mm)) return heights_mm;
    const double level_mm = finest_level_mm(highest_mm);
    if (!std::all_of(heights, heights + kTileCells,
                     [=](float height_mm) { return is_level(height_mm, level_mm); }))
        return heights_mm;
    auto levels = TileBlock<std::uint16_t>::uninitialised();
    std::transform(heights, heights + kTileCells, levels.write(),
                   [=](float height_mm) { return static_cast<std::uint16_t>(height_mm / level_mm); });
    return {std::move(levels), static_cast<float>(level_mm)};
}

TileHeights HeightBlock::read() const {
    if (levels_) return {nullptr, levels_.read(), level_mm_};
    return {heights_mm_.read(), nullptr, 0.0F};
}

std::size_t HeightBlock::bytes() const {
    return kTileCells * (in_levels() ? sizeof(std::uint16_t) : sizeof(float));
}

float* HeightBlock::write() {
    if (in_levels() || !heights_mm_.unique()) *this = copied_heights(read());
    return heights_mm_.write();
}

std::size_t SupportHeights::allocated_bytes() const {
    std::size_t bytes = 0;
    for (int tile = 0; tile < tile_count(); ++tile)
        bytes += is_background(tile) ? 0 : tiles_[tile].bytes();
    return bytes;
}

TileBlock<float> copied_heights(const TileHeights& tile) {
    auto block = TileBlock<float>::uninitialised();
    tile.copy(0, kTileCells, block.write());
    return block;
}

}  // namespace pastoso::film

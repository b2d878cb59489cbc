#include "film/tile_activity.hpp"

#include <algorithm>

namespace pastoso::film {
namespace {

int moved_index(int index, int step, int count, bool periodic) {
    const int moved = index + step;
    if (moved >= 0 && moved < count) return moved;
    return periodic ? (moved + count) % count : -1;
}

}  // namespace

ActivityMap::ActivityMap(grid::Shape shape, double cell_mm, bool sleeping, bool periodic_x,
                         bool periodic_y)
    : shape_(shape),
      cell_mm_(static_cast<float>(cell_mm)),
      sleeping_(sleeping),
      periodic_x_(periodic_x),
      periodic_y_(periodic_y),
      tiles_(shape.tile_count()) {}

std::vector<int> ActivityMap::awake_tiles() const {
    std::vector<int> result;
    for (int tile = 0; tile < shape_.tile_count(); ++tile)
        if (tiles_[tile].awake) result.push_back(tile);
    return result;
}

int ActivityMap::awake_count() const {
    return static_cast<int>(
        std::count_if(tiles_.begin(), tiles_.end(), [](const auto& t) { return t.awake; }));
}

void ActivityMap::wake(int tile) {
    TileActivity& activity = tiles_[tile];
    activity.awake = true;
    activity.changed_from_outside = true;
    activity.window_s = 0.0F;
    activity.motion = {};
}

int ActivityMap::neighbour(int tile, Side side) const {
    const int columns = shape_.tiles_x();
    const int step_x = side == kLeft ? -1 : side == kRight ? 1 : 0;
    const int step_y = side == kTop ? -1 : side == kBottom ? 1 : 0;
    const int x = moved_index(tile % columns, step_x, columns, periodic_x_);
    const int y = moved_index(tile / columns, step_y, shape_.tiles_y(), periodic_y_);
    return x < 0 || y < 0 ? -1 : y * columns + x;
}

bool ActivityMap::record(int tile, float dt_s, const std::optional<TileMotion>& motion,
                         const FlowExtremes& extremes) {
    TileActivity& activity = tiles_[tile];
    activity.changed_from_outside = false;
    activity.extremes = extremes;
    activity.window_s += dt_s;
    if (motion) activity.motion = *motion;
    for (int side = 0; side < kSideCount; ++side) {
        if (activity.motion.near_side_mm[side] <= kWakingTravel_cells * cell_mm_) continue;
        const int other = neighbour(tile, static_cast<Side>(side));
        if (other >= 0 && !tiles_[other].awake) wake(other);
    }
    if (activity.window_s < kRestWindow_s) return false;
    const bool at_rest = sleeping_ && activity.motion.largest_mm < kRestTravel_cells * cell_mm_;
    activity.window_s = 0.0F;
    activity.motion = {};
    if (at_rest) activity = TileActivity{};
    return at_rest;
}

}  // namespace pastoso::film

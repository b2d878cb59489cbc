#include "film/tile_activity.hpp"

#include "film/large/settling.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::film {
namespace {

int moved_index(int index, int step, int count, bool periodic) {
    const int moved = index + step;
    if (moved >= 0 && moved < count) return moved;
    return periodic ? (moved + count) % count : -1;
}

Side opposite(Side side) {
    constexpr std::array kOpposite{kRight, kLeft, kBottom, kTop};
    return kOpposite[side];
}

/// More calls than anything waits.
constexpr int kLongestPace = 1 << 20;

/// Paint of little drag may stand still for a moment, between two swings.
bool remembers_motion(const FlowExtremes& flow, double seconds) {
    return flow.thickness_mm * seconds < kInertialDrag * flow.mobility;
}

/// Cells of this size and larger ones count for the unseen, and of smaller ones as many as that, up to
/// almost a whole cell, which is what a step carries paint at most.
constexpr double kSeenCell_mm = 0.25, kMostCells = 4.0;
constexpr double kMostTravel_cells = 0.8;

}  // namespace

UnseenTravel::UnseenTravel(double cell_mm) {
    const double unseen_mm = std::clamp(kSeenCell_mm, cell_mm, kMostCells * cell_mm);
    const auto travel_mm = [&](double share) {
        return static_cast<float>(std::min(share * unseen_mm, kMostTravel_cells * cell_mm));
    };
    at_rest_mm = 1e-3F * static_cast<float>(cell_mm);
    waking_mm = 5e-4F * static_cast<float>(cell_mm);
    waiting_mm = travel_mm(0.4);
    dammed_mm = travel_mm(0.02);
}

ActivityMap::ActivityMap(grid::Shape shape, double cell_mm, bool sleeping, bool periodic_x,
                         bool periodic_y)
    : shape_(shape),
      unseen_(cell_mm),
      sleeping_(sleeping),
      periodic_x_(periodic_x),
      periodic_y_(periodic_y),
      tiles_(shape.tile_count()) {}

std::vector<int> ActivityMap::stepping_tiles() const {
    std::vector<int> result;
    for (int tile = 0; tile < shape_.tile_count(); ++tile)
        if (tiles_[tile].stepping) result.push_back(tile);
    return result;
}

int ActivityMap::awake_count() const {
    return static_cast<int>(
        std::count_if(tiles_.begin(), tiles_.end(), [](const auto& t) { return t.awake; }));
}

void ActivityMap::restore(std::int64_t calls, std::vector<TileActivity> tiles) {
    calls_ = calls;
    tiles_ = std::move(tiles);
}

void ActivityMap::wake(int tile) {
    TileActivity& activity = tiles_[tile];
    activity.awake = true;
    activity.changed_from_outside = true;
    activity.window_s = 0.0F;
    activity.motion = {};
}

/// Of the fastest paint that is seen in a tile, and of what comes towards it from beside it.
float ActivityMap::speed_mm_s(int tile) const {
    float speed = tiles_[tile].extremes.seen_speed_mm_s;
    for (const Side side : {kLeft, kRight, kTop, kBottom}) {
        const int other = neighbour(tile, side);
        if (other >= 0) speed = std::max(speed, tiles_[other].side_speeds_mm_s[opposite(side)]);
    }
    return speed;
}

int ActivityMap::calls_to_wait(int tile, double seconds, double longest_wait_s) const {
    const TileActivity& activity = tiles_[tile];
    if (!activity.measured || remembers_motion(activity.extremes, seconds)) return 1;
    const int most_calls = activity.changed_from_outside ? kMostCallsWhileTouched : kLongestPace;
    const double travel_mm = speed_mm_s(tile) * seconds;
    int calls = 1;
    while (2 * calls <= most_calls && 2 * calls * seconds <= longest_wait_s &&
           2 * calls * travel_mm <= unseen_.waiting_mm)
        calls *= 2;
    return calls;
}

/// How many calls a flow across the side between two tiles may be held up.
int ActivityMap::calls_to_dam_up(int tile, int other, Side side, double seconds) const {
    const float speed =
        std::max(tiles_[tile].side_speeds_mm_s[side], tiles_[other].side_speeds_mm_s[opposite(side)]);
    int calls = 1;
    while (2 * calls * seconds * speed <= unseen_.dammed_mm && calls < kLongestPace)
        calls *= 2;
    return calls;
}

/// Has tiles wait no longer than those that they exchange paint with, unless little flows between them.
void ActivityMap::level_waits(const std::vector<int>& awake, double seconds,
                              std::vector<int>& calls) const {
    for (bool settled = false; !settled;) {
        settled = true;
        for (const int tile : awake)
            for (const Side side : {kLeft, kRight, kTop, kBottom}) {
                const int other = neighbour(tile, side);
                if (other < 0 || calls[tile] <= calls[other]) continue;
                const int most = std::max(calls[other], calls_to_dam_up(tile, other, side, seconds));
                if (calls[tile] <= most) continue;
                calls[tile] = most;
                settled = false;
            }
    }
}

void ActivityMap::let_pass(double seconds, double longest_wait_s) {
    end_group();
    ++calls_;
    std::vector<int> awake;
    for (int tile = 0; tile < shape_.tile_count(); ++tile)
        if (tiles_[tile].awake) awake.push_back(tile);
    if (awake.empty()) return;
    // A tile that sleeps is a wall to its neighbours, and holds up nothing.
    std::vector<int> calls(shape_.tile_count(), kLongestPace);
    for (const int tile : awake)
        calls[tile] = calls_to_wait(tile, seconds, longest_wait_s);
    level_waits(awake, seconds, calls);
    for (const int tile : awake) {
        TileActivity& activity = tiles_[tile];
        activity.waiting_s += seconds;
        activity.due = calls_ % calls[tile] == 0;
    }
}

void ActivityMap::end_group() {
    for (TileActivity& activity : tiles_) {
        if (!activity.stepping) continue;
        activity.stepping = activity.due = false;
        activity.waiting_s = 0.0;
    }
}

std::optional<double> ActivityMap::begin_group() {
    end_group();
    std::optional<double> shortest_s;
    for (const TileActivity& activity : tiles_)
        if (activity.due && (!shortest_s || activity.waiting_s < *shortest_s))
            shortest_s = activity.waiting_s;
    if (!shortest_s) return shortest_s;
    group_waited_s_ = *shortest_s;
    for (TileActivity& activity : tiles_)
        activity.stepping = activity.due && activity.waiting_s == *shortest_s;
    return shortest_s;
}

void ActivityMap::step_all() {
    group_waited_s_ = 0.0;
    for (TileActivity& activity : tiles_)
        activity.stepping = activity.awake;
}

bool ActivityMap::exchange(int tile, int other) const {
    const TileActivity &a = tiles_[tile], &b = tiles_[other];
    if (!a.awake || !b.awake) return false;
    if (a.stepping && b.stepping) return true;
    return (a.stepping && b.waiting_s < group_waited_s_) ||
           (b.stepping && a.waiting_s < group_waited_s_);
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
                         const FlowExtremes& extremes, const SideSpeeds& side_speeds_mm_s) {
    TileActivity& activity = tiles_[tile];
    activity.changed_from_outside = false;
    activity.measured = true;
    activity.extremes = extremes;
    activity.side_speeds_mm_s = side_speeds_mm_s;
    activity.window_s += dt_s;
    if (motion) activity.motion = *motion;
    for (int side = 0; side < kSideCount; ++side) {
        if (activity.motion.near_side_mm[side] <= unseen_.waking_mm) continue;
        const int other = neighbour(tile, static_cast<Side>(side));
        if (other < 0 || tiles_[other].awake) continue;
        wake(other);
        tiles_[other].stepping = true;
    }
    if (activity.window_s < kRestWindow_s) return false;
    const bool at_rest = sleeping_ && activity.motion.largest_mm < unseen_.at_rest_mm;
    activity.window_s = 0.0F;
    activity.motion = {};
    if (at_rest) activity = TileActivity{};
    return at_rest;
}

}  // namespace pastoso::film

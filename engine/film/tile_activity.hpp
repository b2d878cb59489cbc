// Which tiles are stepped. A tile falls asleep when its paint has come to rest and wakes when something
// reaches it.
#pragma once

#include "film/tile_step.hpp"
#include "grid/shape.hpp"

#include <array>
#include <optional>
#include <vector>

namespace pastoso::film {

enum Side { kLeft, kRight, kTop, kBottom, kSideCount };

/// How far the paint of a tile has moved since its window began: the largest net change of thickness
/// anywhere, and near each side. Net changes leave out the last-bit trembling of paint held by its yield
/// stress.
struct TileMotion {
    float largest_mm = 0.0F;
    std::array<float, kSideCount> near_side_mm{};
};

struct TileActivity {
    bool awake = false;
    bool changed_from_outside = false;  ///< since the last step: its flow is not measured yet
    float window_s = 0.0F;              ///< time since the window began, 0 at its beginning
    TileMotion motion;
    FlowExtremes extremes;  ///< of the last step
};

/// Paint that has moved less than this over a window counts as at rest: a thousandth of a cell in half a
/// second.
inline constexpr float kRestWindow_s = 0.5F;
inline constexpr float kRestTravel_cells = 1e-3F;
/// Motion beside an edge that wakes the tile behind it.
inline constexpr float kWakingTravel_cells = 5e-4F;

class ActivityMap {
  public:
    ActivityMap(grid::Shape shape, double cell_mm, bool sleeping, bool periodic_x, bool periodic_y);

    bool awake(int tile) const { return tiles_[tile].awake; }
    const TileActivity& tile(int tile) const { return tiles_[tile]; }
    std::vector<int> awake_tiles() const;
    int awake_count() const;

    void wake(int tile);
    /// The tile beyond a side, -1 beyond the canvas.
    int neighbour(int tile, Side side) const;

    /// True when the next step of the tile begins a window, from which its motion is counted.
    bool window_begins(int tile) const { return tiles_[tile].window_s == 0.0F; }

    /// Records a step of an awake tile, wakes neighbours that its motion reaches, and returns true when
    /// the tile has come to rest and fell asleep. No `motion`: the thickness did not change in this
    /// step.
    bool record(int tile, float dt_s, const std::optional<TileMotion>& motion,
                const FlowExtremes& extremes);

  private:
    grid::Shape shape_;
    float cell_mm_;
    bool sleeping_, periodic_x_, periodic_y_;
    std::vector<TileActivity> tiles_;
};

}  // namespace pastoso::film

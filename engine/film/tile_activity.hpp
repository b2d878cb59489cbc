// Which tiles are stepped, and when. A tile falls asleep when its paint has come to rest and wakes when
// something reaches it; one whose paint hardly moves waits, and takes the time that it has waited in one
// step.
#pragma once

#include "film/explicit/tile_step.hpp"
#include "grid/shape.hpp"

#include <array>
#include <cstdint>
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

/// The largest speeds across a tile's sides and the faces next to them.
using SideSpeeds = std::array<float, kSideCount>;

struct TileActivity {
    bool awake = false;
    bool stepping = false;              ///< takes part in the step under way
    bool due = false;                   ///< is to be stepped before the time that passes is over
    bool measured = false;              ///< whether `extremes` are known
    bool changed_from_outside = false;  ///< since the last step: its flow may have changed
    double waiting_s = 0.0;             ///< time that has passed, but not for this tile yet
    float window_s = 0.0F;              ///< time since the window began, 0 at its beginning
    TileMotion motion;
    FlowExtremes extremes;          ///< of the last step
    SideSpeeds side_speeds_mm_s{};  ///< likewise
};

/// How far paint may move unseen. What waits catches up: an eye sees millimetres, and in cells smaller
/// than a quarter of one it may go as far as in those. What rests stays behind, and goes by cells.
struct UnseenTravel {
    explicit UnseenTravel(double cell_mm);

    /// Paint that has moved less than this over a window of kRestWindow_s counts as at rest: a
    /// thousandth of a cell.
    float at_rest_mm;
    /// Motion beside an edge that wakes the tile behind it.
    float waking_mm;
    /// Paint may wait for as long as it moves by less than this: two fifths of a cell.
    float waiting_mm;
    /// Two tiles that wait differently dam up what flows from one to the other until the slower one is
    /// stepped: they do so only while that is less than what fills this much of a cell.
    float dammed_mm;
};
inline constexpr float kRestWindow_s = 0.5F;

/// The most calls of let_pass() that paint waits on which a tool works.
inline constexpr int kMostCallsWhileTouched = 4;

class ActivityMap {
  public:
    ActivityMap(grid::Shape shape, double cell_mm, bool sleeping, bool periodic_x, bool periodic_y);

    const TileActivity& tile(int tile) const { return tiles_[tile]; }
    std::vector<int> stepping_tiles() const;
    int awake_count() const;

    /// How often let_pass() was called: waits end together by it.
    std::int64_t calls() const { return calls_; }
    /// Goes on from what another map of this shape held between two calls of let_pass().
    void restore(std::int64_t calls, std::vector<TileActivity> tiles);

    void wake(int tile);

    /// Lets time pass for all tiles that are awake. Due are those whose paint could move noticeably if
    /// they went on waiting, and none waits longer than `longest_wait_s`. Waits are a power of two of
    /// such calls, and end together.
    void let_pass(double seconds, double longest_wait_s);
    /// Has the due tiles that have waited least take part in steps; returns how long they have waited,
    /// or nothing when no tile is due. They take part until the next group begins or time passes again.
    std::optional<double> begin_group();
    /// All tiles that are awake take part, whatever they have waited.
    void step_all();
    /// Whether paint passes between neighbours in a step of the group. A face waits as long as the
    /// slower of its tiles, and is then stepped with it.
    bool exchange(int tile, int other) const;
    /// The tile beyond a side, -1 beyond the canvas.
    int neighbour(int tile, Side side) const;

    /// True when the next step of the tile begins a window, from which its motion is counted.
    bool window_begins(int tile) const { return tiles_[tile].window_s == 0.0F; }

    /// Records a step of a tile that takes part, wakes neighbours that its motion reaches, and returns
    /// true when the tile has come to rest and fell asleep. No `motion`: the thickness did not change in
    /// this step.
    bool record(int tile, float dt_s, const std::optional<TileMotion>& motion,
                const FlowExtremes& extremes, const SideSpeeds& side_speeds_mm_s);

  private:
    float speed_mm_s(int tile) const;
    int calls_to_wait(int tile, double seconds, double longest_wait_s) const;
    int calls_to_dam_up(int tile, int other, Side side, double seconds) const;
    void level_waits(const std::vector<int>& awake, double seconds, std::vector<int>& calls) const;
    void end_group();

    grid::Shape shape_;
    UnseenTravel unseen_;
    bool sleeping_, periodic_x_, periodic_y_;
    std::int64_t calls_ = 0;
    double group_waited_s_ = 0.0;
    std::vector<TileActivity> tiles_;
};

}  // namespace pastoso::film

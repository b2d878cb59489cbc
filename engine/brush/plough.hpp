// A moving tip shoves the wet paint in its way before the hairs reach it: ahead of itself, as a bow
// wave, and near its edges out to the side, where it stays as a ridge.
#pragma once

#include "brush/bristle_motion.hpp"
#include "brush/brush.hpp"
#include "brush/cell_batch.hpp"
#include "brush/hand_pose.hpp"
#include "brush/spill.hpp"
#include "brush/transfer.hpp"
#include "film/state.hpp"

#include <array>
#include <vector>

namespace pastoso::brush {

/// The share of the paint in its way that a tip pushes along; the rest passes below it:
///
///     p = 1 - e^(-momentum v / 100 mm/s)
///
/// for momentum from 0 to 1 and a speed v >= 0 in mm/s. The faster, the less time paint has to give way.
double pushed_share(double momentum, double speed_mm_s);

/// What a plough works with in one step.
struct PloughStep {
    Brush& brush;
    const std::vector<BristlePose>& poses;
    const HandPose& hand;
    const Swath& swath;
    const StepRates& rates;
    std::uint32_t dither_seed;
    film::FilmState& film;
    CellBatch& scratch;
    MediaExchange* media;  ///< as of apply()
};

/// The swath is divided into lanes b wide, each led by its foremost element. In a step ds a lane loses,
/// of the height |g| by which the paint 2 footprint radii r ahead of the leader stands above its
/// underside,
///
///     (1 - (1 - u)^v) |g|,   u = p (1 - e^(-ds / 0.8 r)) (1 - (along / r)^4) min(1, |g| / 0.1 mm),
///
/// v being the mean of 1 - |across| / b over the width of a cell (brush/lane_weight.hpp).
/// Of that the share e^(-d / l) goes to a heap beside each edge of the swath, d away, with l = p / 4 of
/// the tip's half width (all of it, if the two shares make more), the rest to one 2 r further ahead.
/// Heaps beside are as wide as a footprint or wider: they lie 0.8 r apart, and narrower ones are beads.
/// Whole quanta are moved with their pigment. A twentieth, and what would come to lie on bare ground or
/// beyond the canvas, clings to the leader.
class Plough {
  public:
    /// Returns the cells that may have changed.
    grid::Rect push(const PloughStep& step);

  private:
    struct Lane {
        int leader = -1;         ///< -1 where nothing touches
        double front_mm = 0.0;   ///< of the leader, from the pen along the travel
        double middle_mm = 0.0;  ///< from the pen across the travel
    };
    void divide(const PloughStep& step);
    /// Moves the front of every lane up to those of its neighbours, whose marks reach into it: a tip
    /// does not plough what it lays down itself.
    void align_fronts();
    Contents clear(const PloughStep& step, const Lane& lane);
    /// What a change of the film is told the media of.
    MediaExchange* pile_of(const PloughStep& step) { return step.media != nullptr ? &pile_ : nullptr; }
    void pile_up_media(const MediaExchange& before);
    void heap_ahead(const PloughStep& step, const Lane& lane, Contents moved);
    void heap_beside(const PloughStep& step, double sign, Contents moved);
    void heap(const PloughStep& step, int leader, const HeapPlace& place, Contents& moved);

    std::vector<Lane> lanes_;  ///< that something leads, from one edge to the other
    std::vector<double> fronts_mm_;
    double lane_width_mm_ = 1.0;
    double pushed_ = 0.0;
    MediaExchange pile_;                                 ///< gives what was cleared in this step, ...
    std::array<double, film::kMostMedia> pile_media_{};  ///< quanta of each medium
    grid::Rect changed_;
};

}  // namespace pastoso::brush

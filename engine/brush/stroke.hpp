// A stroke: pen samples in, paint on the film out.
#pragma once

#include "brush/bearing.hpp"
#include "brush/bristle_motion.hpp"
#include "brush/brush.hpp"
#include "brush/cell_batch.hpp"
#include "brush/clumps.hpp"
#include "brush/drag.hpp"
#include "brush/droplets.hpp"
#include "brush/hand_path.hpp"
#include "brush/pass_map.hpp"
#include "brush/plough.hpp"
#include "brush/strips.hpp"
#include "brush/symmetry.hpp"
#include "brush/transfer.hpp"
#include "core/thread_pool.hpp"
#include "film/air_jet.hpp"
#include "film/state.hpp"

#include <deque>
#include <mutex>
#include <optional>
#include <vector>

namespace pastoso::brush {

/// Follows a hand (HandPath), and at every step the bristles exchange paint with the film. The stroke
/// does not depend on the rate of the samples, and hardly on the size of the cells. Holds on to the
/// brush and the film, which must outlive it; between two calls the film may flow, and may be replaced
/// by an earlier or later state of the same canvas.
class Stroke {
  public:
    /// `placement` says where the brush stands for the hand. What GuideChoice chooses has to be chosen
    /// already. Tools change the cells of `limit` alone, which outlives the stroke (null: all of them),
    /// and those of air blow only where the middle of their jet is on one. The bits do not depend on the
    /// threads of `pool`, which outlives the stroke as well (null: one thread).
    Stroke(Brush& brush, film::FilmState& film, const HandAids& aids = {},
           const Placement& placement = {}, const grid::Mask* limit = nullptr,
           core::ThreadPool* pool = nullptr);

    /// Leads the strokes from the next on, in place of what the aids have.
    void keep_to(const PenGuide& guide) { path_.keep_to(guide); }

    /// The pen touches down. All numbers of samples must be finite, pressures 0 to 1; far off the canvas
    /// they cost time and do nothing.
    void begin(const PenSample& sample);

    /// The pen has moved, pressed or turned. Times should not decrease.
    void add(const PenSample& sample);

    /// The pen lifts at the last sample.
    void end();

    /// Lets time pass while the pen is down: drops go on falling where it is held still.
    void pass_time(double seconds);

    /// What a tool of air blows on the film at this moment; none for the others.
    std::optional<film::AirJet> air_jet() const;

    /// A rectangle around all cells changed since the last call; empty if none.
    grid::Rect take_changed_cells();

  private:
    /// What all elements that touch in one step have in common.
    struct Touch {
        const HandPose& hand;
        const Swath& swath;
        const StepRates& rates;
        const DragRates& drag;
    };
    /// What the thread on a strip works with, apart from what others write.
    struct alignas(64) StripTools {
        explicit StripTools(const grid::Mask* limit) : cells(limit) {}
        CellBatch cells;
        PaintDrag drag;
        MediaExchange media;
        grid::Rect changed;
    };

    HandPose pose(const PathStep& step) const;
    StrokeState state() const;
    void roll(HandPose& hand);
    /// Of the cell there that tools may change, 0 to 1.
    double free_share(double x_mm, double y_mm) const;
    void paint_steps();
    void take_step(const PathStep& step);
    void paint_step(const PathStep& step);
    void plough(const HandPose& hand, const Swath& swath);
    void touch_all(const Touch& touch);
    Bearing bearing(const HandPose& hand, const Swath& swath) const;
    Contact contact(int bristle, const Touch& touch) const;
    /// Contact::alone: whether cells beyond its own clump see the bristle.
    float alone(int bristle) const;
    float thrown_up(int bristle) const;
    double left_share(int bristle) const;
    double torn_share(int bristle) const;
    /// False: other threads may be at work on tiles that the film shares with other states.
    bool touch_one(int bristle, const Touch& touch, StripTools& tools);
    /// What a change of the film is told the media of; null where that is of one.
    MediaExchange* media() { return media_ ? &*media_ : nullptr; }
    void share_media();
    void collect_media();
    void leave_paint();
    void note_changed(const grid::Rect& cells);
    std::uint32_t dither_seed(int bristle) const;

    Brush& brush_;
    film::FilmState& film_;
    const grid::Mask* limit_;
    ResolvedTip resolved_;  ///< on the cells of the film
    std::uint32_t turns_;   ///< steps from one exchange of a bristle to its next
    Placement placement_;
    HandPath path_;
    std::vector<BristlePose> poses_;
    CellBatch cells_;
    PassMap pass_;
    Plough plough_;
    core::ThreadPool* pool_;
    std::vector<StripPlace> touching_;  ///< in this step, in their order
    Clumps clumps_;
    Strips strips_;
    std::deque<StripTools> tools_;  ///< of every strip
    std::mutex velocities_;         ///< of the film
    std::optional<MediaExchange> media_;  ///< on a film of several
    Droplets droplets_;
    bool reads_load_;                  ///< some curve does
    std::optional<HandPose> blowing_;  ///< how a tool of air is held, before it is placed
    double time_s_ = 0.0;              ///< that the stroke has lasted
    double begun_s_ = 0.0;             ///< time of the pen when it came down
    std::optional<HandPose> rolled_;   ///< how a roller was held in the step before
    std::uint32_t jitter_seed_ = 0;
    std::uint32_t step_count_ = 0;
    double since_wick_mm_ = 0.0;
    grid::Rect changed_;
};

}  // namespace pastoso::brush

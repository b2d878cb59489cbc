// A stroke: pen samples in, paint on the film out.
#pragma once

#include "brush/bearing.hpp"
#include "brush/bristle_motion.hpp"
#include "brush/brush.hpp"
#include "brush/cell_batch.hpp"
#include "brush/clumps.hpp"
#include "brush/drag.hpp"
#include "brush/droplets.hpp"
#include "brush/pass_map.hpp"
#include "brush/pen_filter.hpp"
#include "brush/pen_guide.hpp"
#include "brush/pen_resampler.hpp"
#include "brush/plough.hpp"
#include "brush/strips.hpp"
#include "brush/stroke_path.hpp"
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

/// What helps the hand, whatever the brush.
struct HandAids {
    Stabiliser stabiliser{};
    PenGuide guide{};
};

/// Samples are filled up along a smooth curve, filtered in time, led along the guide and walked in steps
/// of equal length; at every step the bristles exchange paint with the film. The stroke does not depend
/// on the rate of the samples, and hardly on the size of the cells. Paint follows the pen by the
/// filter's time constant, one sample and 2 ms; end() catches up. Holds on to the brush and the film,
/// which must outlive it; between two calls the film may flow, and may be replaced by an earlier or
/// later state of the same canvas.
class Stroke {
  public:
    /// `placement` says where the brush stands for the hand. A straight line has to be straight already.
    /// Tools change the cells of `limit` alone, which outlives the stroke (null: all of them), and those
    /// of air blow only where the middle of their jet is on one. The bits do not depend on the threads
    /// of `pool`, which outlives the stroke as well (null: one thread).
    Stroke(Brush& brush, film::FilmState& film, const HandAids& aids = {},
           const Placement& placement = {}, const grid::Mask* limit = nullptr,
           core::ThreadPool* pool = nullptr);

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

    void follow(const std::vector<PenSample>& samples);
    PenSample led(const PenSample& sample);
    HandPose pose(const PathStep& step) const;
    bool may_change(double x_mm, double y_mm) const;
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
    double step_mm_;
    std::uint32_t turns_;  ///< steps from one exchange of a bristle to its next
    PenGuide guide_;
    Placement placement_;
    PenResampler events_;
    PenFilter filter_;
    PenSample down_, led_;  ///< the first sample, and the last one with the guide's help
    StrokePath path_;
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
    std::optional<HandPose> blowing_;  ///< how a tool of air is held, before it is placed
    double time_s_ = 0.0;              ///< that the stroke has lasted
    std::uint32_t jitter_seed_ = 0;
    std::uint32_t step_count_ = 0;
    double since_wick_mm_ = 0.0;
    grid::Rect changed_;
};

}  // namespace pastoso::brush

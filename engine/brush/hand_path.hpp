// The way of a brush that is led by a hand: samples of the pen in, steps of the brush out.
#pragma once

#include "brush/pen_filter.hpp"
#include "brush/pen_guide.hpp"
#include "brush/pen_resampler.hpp"
#include "brush/stroke_path.hpp"
#include "brush/tip.hpp"

#include <vector>

namespace pastoso::brush {

/// What helps the hand, whatever the brush.
struct HandAids {
    Stabiliser stabiliser{};
    PenGuide guide{};
};

/// Samples are filled up along a smooth curve, filtered in time, led along the guide and walked in steps
/// of equal length, whatever the rate of the samples. The brush follows the pen by the filter's time
/// constant, one sample and 2 ms; end() catches up. What GuideChoice chooses has to be chosen already. A
/// copy goes on on its own.
class HandPath {
  public:
    HandPath(const Preset& preset, const Tip& tip, const HandAids& aids);

    /// Leads the strokes from the next on.
    void keep_to(const PenGuide& guide) { guide_ = guide; }
    const PenGuide& guide() const { return guide_; }

    /// The pen touches down. All numbers of samples must be finite, pressures 0 to 1. Returns where the
    /// brush comes down.
    PenSample begin(const PenSample& sample);

    /// The pen has moved, pressed or turned. Times should not decrease.
    void add(const PenSample& sample);

    /// The pen lifts at the last sample.
    void end();

    /// Since the last call.
    std::vector<PathStep> take_steps() { return path_.take_steps(); }

    double step_mm() const { return measure_.step_mm; }
    double travelled_mm() const { return path_.travelled_mm(); }  ///< since the pen touched down

  private:
    void follow(const std::vector<PenSample>& samples);
    PenSample led(const PenSample& sample);

    PathMeasure measure_;
    PenGuide guide_;
    PenResampler events_;
    PenFilter filter_;
    PenSample down_, led_;  ///< the first sample, and the last one with the guide's help
    StrokePath path_;
};

}  // namespace pastoso::brush

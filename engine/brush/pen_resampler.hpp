// Events that come seldom, told as often as those of a fast pen.
#pragma once

#include "brush/pen_sample.hpp"

#include <array>
#include <vector>

namespace pastoso::brush {

/// A sample as it follows another one: at least 0.1 ms later, and its rotation without the jump from 360
/// to 0.
PenSample following(const PenSample& before, const PenSample& sample);

/// Fills the smooth way between the pen's events (brush/pen_curve.hpp) with samples at most 2 ms apart.
/// What comes after would take it for straight, so that a hand that turns, presses or lifts would do so
/// differently at every rate of events. Stays behind by one event.
class PenResampler {
  public:
    /// Starts anew at the sample, which is not given out.
    void start(const PenSample& sample);

    /// The samples up to the event before this one. Valid until the next call.
    const std::vector<PenSample>& add(const PenSample& sample);

    /// Those up to the last event.
    const std::vector<PenSample>& end();

  private:
    void fill(const PenSample& after);

    std::array<PenSample, 3> last_{};  ///< events, the newest one last; at first all the same
    bool moved_ = false;               ///< more than one event
    std::vector<PenSample> filled_;
};

}  // namespace pastoso::brush

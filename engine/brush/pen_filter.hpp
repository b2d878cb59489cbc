// Steadies the hand: a low-pass filter in time, whatever the rate of the events.
#pragma once

#include "brush/pen_sample.hpp"

namespace pastoso::brush {

/// A one-pole filter, ds/dt = (x - s) / tau, solved exactly for an input that runs straight from sample
/// to sample: a steady hand is followed tau late, at 60 Hz as at 1000. After it, if `string_mm` > 0, the
/// tip follows like something pulled on a string of that length.
class PenFilter {
  public:
    PenFilter(double time_constant_s, double string_mm);

    /// Starts anew at the sample, which is the result. Rotations count on from here, without the jump
    /// from 360 to 0.
    PenSample start(const PenSample& sample);

    /// The filtered sample at the time of `sample`. Times that do not increase are taken as 0.1 ms
    /// apart.
    PenSample follow(const PenSample& sample);

    /// Where the path has to end: the last sample given, at the time when a steady hand's filtered path
    /// is there.
    PenSample final_sample() const;

  private:
    PenSample pulled(const PenSample& target) const;

    double time_constant_s_;
    double string_mm_;
    PenSample input_;     ///< last sample, its time increasing, its rotation without jumps
    PenSample smoothed_;  ///< before the string
    PenSample output_;
};

}  // namespace pastoso::brush

// Steadies the hand: a low-pass filter in time, whatever the rate of the events.
#pragma once

#include "brush/pen_sample.hpp"
#include "brush/preset.hpp"

namespace pastoso::brush {

/// What the painter asks for besides the brush's own smoothing; 0 leaves it at that.
struct Stabiliser {
    double smoothing_ms = 0.0;  ///< added to the preset's time constant
    double string_mm = 0.0;     ///< a longer string than the preset's takes its place
    friend bool operator==(const Stabiliser&, const Stabiliser&) = default;
};

/// A one-pole filter, ds/dt = (x - s) / tau, solved exactly for an input that runs straight from sample
/// to sample: a steady hand is followed tau late, at 60 Hz as at 1000. After it, if `string_mm` > 0, the
/// tip is pulled on a string of that length: it rests while the string is slack, and trails (a tractrix,
/// solved exactly for straight pulls) once it is taut.
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
    PenSample pulled(const PenSample& from, const PenSample& to) const;

    double time_constant_s_;
    double string_mm_;
    PenSample input_;     ///< last sample, its time increasing, its rotation without jumps
    PenSample smoothed_;  ///< before the string
    PenSample output_;
};

/// The filter of a brush with the painter's wishes.
PenFilter steadying_filter(const StrokePreset& stroke, const Stabiliser& stabiliser);

}  // namespace pastoso::brush

// The way of the pen between two of its samples.
#pragma once

#include "brush/pen_sample.hpp"

#include <array>

namespace pastoso::brush {

/// Hermite's cubic through two samples in all that a sample tells. Its tangents are finite differences
/// in time over both neighbours, at most 1.5 times as long as the chord: after a pause they could be
/// much longer, and the curve would swing back before it starts.
class PenCurve {
  public:
    /// `before` may be `from`, and `after` may be `to`, where there is no other.
    PenCurve(const PenSample& before, const PenSample& from, const PenSample& to,
             const PenSample& after);

    /// From the first sample at t = 0 to the second at t = 1; pressures stay within 0 and 1.
    PenSample at(double t) const;

  private:
    struct Vector {
        double x, y;
    };
    static constexpr std::array kScalars = {&PenSample::pressure, &PenSample::tilt_x_deg,
                                            &PenSample::tilt_y_deg, &PenSample::rotation_deg,
                                            &PenSample::wheel};

    PenSample from_, to_;
    Vector tangent_from_, tangent_to_;
    std::array<double, kScalars.size()> scalar_from_, scalar_to_;
};

/// On the straight way from one sample to another, in all that a sample tells.
PenSample between(const PenSample& from, const PenSample& to, double t);

/// Mean speed from one sample to a later one.
double mean_speed_mm_s(const PenSample& from, const PenSample& to);

}  // namespace pastoso::brush

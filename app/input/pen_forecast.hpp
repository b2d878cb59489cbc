// Where a pen is about to be: what is shown of a stroke lags behind the hand by less.
#pragma once

#include "brush/pen_sample.hpp"

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

namespace pastoso::input {

/// A Kalman filter for a hand of constant velocity that white noise accelerates. Both directions have
/// the state (place, velocity), and one covariance P:
///
///   F = (1 dt; 0 1),  Q = q (dt^3/3 dt^2/2; dt^2/2 dt),  P- = F P F' + Q,
///   K = P- H' / (P-_00 + r),  H = (1 0),  P = (1 - K H) P-,
///
/// where only q / r counts (Bar-Shalom, Li and Kirubarajan, Estimation with Applications to Tracking and
/// Navigation, 2001, sections 5.2.3 and 6.2.2): whether the canvas is seen from near or far does not.
class PenForecast {
  public:
    /// The pen has touched down, and rests as far as is known.
    void start(const brush::PenSample& sample);

    /// It has moved. A time that does not increase replaces what was told of it before.
    void add(const brush::PenSample& sample);

    /// The sample that is due so much later, at least 0: held as the last one is.
    brush::PenSample after(double ahead_s) const;

  private:
    brush::PenSample last_;
    glm::dvec2 place_mm_{}, velocity_mm_s_{};
    glm::dmat2 covariance_{0.0};
};

}  // namespace pastoso::input

#include "input/pen_forecast.hpp"

#include <glm/matrix.hpp>

namespace pastoso::input {
namespace {

/// Of the place that a pen tells, r; the unit is free.
constexpr double kPlaceVariance = 1.0;

/// q / r in 1/s3: what foretold half a minute of recorded painting best, to 0.61 of the mean way (root
/// of squares) in 16 ms.
constexpr double kNoise = 1e7;

/// Of the velocity at first, in which nothing is known: such that the second sample tells it.
constexpr double kUnknownVelocity = 1e9;

}  // namespace

void PenForecast::start(const brush::PenSample& sample) {
    last_ = sample;
    place_mm_ = {sample.x_mm, sample.y_mm};
    velocity_mm_s_ = {};
    covariance_ = glm::dmat2(kPlaceVariance, 0.0, 0.0, kUnknownVelocity);
}

void PenForecast::add(const brush::PenSample& sample) {
    const double dt = sample.time_s - last_.time_s;
    last_ = sample;
    if (dt <= 0.0) return;
    const glm::dmat2 forward(1.0, 0.0, dt, 1.0);  // by columns
    const glm::dmat2 noise(dt * dt * dt / 3.0, dt * dt / 2.0, dt * dt / 2.0, dt);
    const glm::dmat2 foretold = forward * covariance_ * glm::transpose(forward) + kNoise * noise;
    const glm::dvec2 gain = foretold[0] / (foretold[0][0] + kPlaceVariance);
    place_mm_ += dt * velocity_mm_s_;
    const glm::dvec2 surprise_mm = glm::dvec2(sample.x_mm, sample.y_mm) - place_mm_;
    place_mm_ += gain.x * surprise_mm;
    velocity_mm_s_ += gain.y * surprise_mm;
    covariance_ = foretold - glm::outerProduct(gain, glm::dvec2(foretold[0][0], foretold[1][0]));
}

brush::PenSample PenForecast::after(double ahead_s) const {
    brush::PenSample sample = last_;
    sample.time_s += ahead_s;
    sample.x_mm += ahead_s * velocity_mm_s_.x;
    sample.y_mm += ahead_s * velocity_mm_s_.y;
    return sample;
}

}  // namespace pastoso::input

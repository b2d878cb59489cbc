#include "brush/pen_filter.hpp"

#include "brush/pen_resampler.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::brush {
namespace {

constexpr double kLeastInterval_s = 1e-4;

constexpr double PenSample::*kFilteredValues[] = {
    &PenSample::x_mm,       &PenSample::y_mm,         &PenSample::pressure, &PenSample::tilt_x_deg,
    &PenSample::tilt_y_deg, &PenSample::rotation_deg, &PenSample::wheel};

}  // namespace

PenFilter::PenFilter(double time_constant_s, double string_mm)
    : time_constant_s_(time_constant_s), string_mm_(string_mm) {}

PenSample PenFilter::start(const PenSample& sample) {
    return input_ = smoothed_ = output_ = sample;
}

PenSample PenFilter::follow(const PenSample& sample) {
    const PenSample next = following(input_, sample);
    const PenSample before = smoothed_;
    if (time_constant_s_ > 0.0) {
        const double ratio = (next.time_s - input_.time_s) / time_constant_s_;
        const double remaining = std::exp(-ratio);
        for (const auto value : kFilteredValues) {
            const double lag = (next.*value - input_.*value) / ratio;
            smoothed_.*value = next.*value - lag + (smoothed_.*value - input_.*value + lag) * remaining;
        }
        smoothed_.time_s = next.time_s;
    } else {
        smoothed_ = next;
    }
    input_ = next;
    return output_ = pulled(before, smoothed_);
}

PenSample PenFilter::final_sample() const {
    PenSample last = input_;
    last.time_s += std::max(time_constant_s_, kLeastInterval_s);
    return last;
}

/// With the string at an angle theta to a straight pull of length s, tan(theta / 2) falls as
/// e^(-s / string).
PenSample PenFilter::pulled(const PenSample& from, const PenSample& to) const {
    if (string_mm_ <= 0.0) return to;
    PenSample result = to;
    result.x_mm = output_.x_mm;
    result.y_mm = output_.y_mm;
    const double pull_mm = std::hypot(to.x_mm - from.x_mm, to.y_mm - from.y_mm);
    const double distance_mm = std::hypot(to.x_mm - output_.x_mm, to.y_mm - output_.y_mm);
    if (pull_mm <= 0.0 || distance_mm <= string_mm_) return result;
    const double ahead_x = (to.x_mm - from.x_mm) / pull_mm, ahead_y = (to.y_mm - from.y_mm) / pull_mm;
    const double x = from.x_mm - output_.x_mm, y = from.y_mm - output_.y_mm;
    const double along_mm = x * ahead_x + y * ahead_y, beside_mm = y * ahead_x - x * ahead_y;
    const double side_mm = std::min(std::abs(beside_mm), string_mm_);
    const double taut_along_mm = std::sqrt(string_mm_ * string_mm_ - side_mm * side_mm);
    const double taut_pull_mm = std::clamp(pull_mm + along_mm - taut_along_mm, 0.0, pull_mm);
    const double half_angle = 0.5 * std::atan2(side_mm, std::max(along_mm, taut_along_mm));
    const double angle = std::copysign(
        2.0 * std::atan(std::tan(half_angle) * std::exp(-taut_pull_mm / string_mm_)), beside_mm);
    const double c = string_mm_ * std::cos(angle), s = string_mm_ * std::sin(angle);
    result.x_mm = to.x_mm - (c * ahead_x - s * ahead_y);
    result.y_mm = to.y_mm - (c * ahead_y + s * ahead_x);
    return result;
}

PenFilter steadying_filter(const StrokePreset& stroke, const Stabiliser& stabiliser) {
    return {(stroke.smoothing_ms + stabiliser.smoothing_ms) / 1000.0,
            std::max(stroke.string_mm, stabiliser.string_mm)};
}

}  // namespace pastoso::brush

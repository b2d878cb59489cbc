#include "brush/pen_filter.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::brush {
namespace {

constexpr double kLeastInterval_s = 1e-4;

constexpr double PenSample::*kFilteredValues[] = {&PenSample::x_mm,       &PenSample::y_mm,
                                                  &PenSample::pressure,   &PenSample::tilt_x_deg,
                                                  &PenSample::tilt_y_deg, &PenSample::rotation_deg};

}  // namespace

PenFilter::PenFilter(double time_constant_s, double string_mm)
    : time_constant_s_(time_constant_s), string_mm_(string_mm) {}

PenSample PenFilter::start(const PenSample& sample) {
    return input_ = smoothed_ = output_ = sample;
}

PenSample PenFilter::follow(const PenSample& sample) {
    PenSample next = sample;
    next.time_s = std::max(sample.time_s, input_.time_s + kLeastInterval_s);
    next.rotation_deg =
        input_.rotation_deg + std::remainder(sample.rotation_deg - input_.rotation_deg, 360.0);
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
    return output_ = pulled(smoothed_);
}

PenSample PenFilter::final_sample() const {
    PenSample last = input_;
    last.time_s += std::max(time_constant_s_, kLeastInterval_s);
    return last;
}

PenSample PenFilter::pulled(const PenSample& target) const {
    if (string_mm_ <= 0.0) return target;
    const double dx = target.x_mm - output_.x_mm, dy = target.y_mm - output_.y_mm;
    const double distance = std::hypot(dx, dy);
    const double share = distance > string_mm_ ? 1.0 - string_mm_ / distance : 0.0;
    PenSample result = target;
    result.x_mm = output_.x_mm + dx * share;
    result.y_mm = output_.y_mm + dy * share;
    return result;
}

}  // namespace pastoso::brush

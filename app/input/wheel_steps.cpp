#include "input/wheel_steps.hpp"

#include <cmath>

namespace pastoso::input {
namespace {

/// Twenty notches from end to end.
constexpr double kNotch = 0.1;

/// So that a notch that is not quite reached in floating point counts.
constexpr double kSlack = 1e-9;

}  // namespace

int WheelSteps::moved_to(double wheel) {
    if (!counted_) counted_ = wheel;
    const double way = (wheel - *counted_) / kNotch;
    const double whole = std::trunc(way + std::copysign(kSlack, way));
    *counted_ += whole * kNotch;
    return static_cast<int>(whole);
}

}  // namespace pastoso::input

#include "film/validation/laws.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::film::validation {

using core::kPi;

double nusselt_speed(double force, double h, double viscosity, double alpha) {
    return force * h * h * (3 * alpha - 1) / (6 * viscosity);
}

double plastic_speed(const PlasticPaint& paint, double force, double h) {
    const double n = paint.flow_index, wall = force * h;
    if (wall <= paint.yield) return 0.0;
    const double sheared = 1 - paint.yield / wall;
    const double rate = std::pow((wall - paint.yield) / paint.consistency, 1 / n);
    return h * rate * n / (n + 1) * sheared * (1 - n / (2 * n + 1) * sheared);
}

double SlopeCurrent::front(double t) const {
    return std::cbrt(9 * area * area * force * t / (4 * viscosity));
}

double SlopeCurrent::h(double x, double t) const {
    return x > 0 && x < front(t) ? std::sqrt(viscosity * x / (force * t)) : 0.0;
}

double SlopeCurrent::mean(double from, double to, double t) const {
    const double end = std::min(to, front(t)), start = std::max(from, 0.0);
    if (end <= start) return 0.0;
    return (std::pow(end, 1.5) - std::pow(start, 1.5)) * 2 / 3 * std::sqrt(viscosity / (force * t)) /
           (to - from);
}

double RoundCurrent::radius(double t) const {
    return 0.8944 * std::pow(gravity * volume * volume * volume / (3 * viscosity) * t, 0.125);
}

double RoundCurrent::height(double t) const {
    return 4 * volume / (3 * kPi * radius(t) * radius(t));
}

double RoundCurrent::h(double r, double t) const {
    const double s = r / radius(t);
    return s >= 1 ? 0.0 : height(t) * std::cbrt(1 - s * s);
}

double ripple_rate(double gravity, double tension, double h, double wavenumber, double viscosity) {
    const double k2 = wavenumber * wavenumber;
    return h * h * h * k2 * (gravity + tension * k2) / (3 * viscosity);
}

double YieldedHeap::height() const {
    return std::cbrt(3 * half_area * yield / gravity);
}

double YieldedHeap::reach() const {
    return height() * height() * gravity / (2 * yield);
}

double YieldedHeap::h(double x) const {
    return x < reach() ? std::sqrt(2 * yield / gravity * (reach() - x)) : 0.0;
}

double RetractingStrip::last_half_width() const {
    return std::sqrt(1.5 * section / receding);
}

double RetractingStrip::retreat_speed(double half_width) const {
    const double slope = 1.5 * section / (half_width * half_width);
    const double stretch = std::log(2.0 * half_width * receding / (std::exp(2.0) * (3.0 * slip)));
    return tension / viscosity * (std::pow(receding, 3) - std::pow(slope, 3)) / (9.0 * stretch);
}

double yielded_tail(double force, double yield, double viscosity, double x, double t) {
    const double stands = yield / force;
    if (x <= 0) return stands;
    return 0.5 * (stands + std::sqrt(stands * stands + 4 * x * viscosity / (force * t)));
}

}  // namespace pastoso::film::validation

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

namespace {

/// The root of a function that rises from `low` to `high`.
template <class Function>
double root_of(const Function& function, double low, double high) {
    for (int halving = 0; halving < 50; ++halving) {
        const double middle = 0.5 * (low + high);
        (function(middle) < 0.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// The film beside a front at z = `front`, z = x / (g h^3/(3 nu) t)^(1/2), in units of its thickness far
/// away: f = h^3 h', f' = -z h'/2, and the front goes with the paint, f = -h front/2. Returns what h
/// comes to far away in this direction (1 or -1).
double far_thickness(double at_front, double front, double direction) {
    constexpr int kSteps = 4000;
    const double step = direction * 12.0 / kSteps;
    double h = at_front, flux = -0.5 * front * at_front;
    for (int i = 0; i < kSteps; ++i) {
        const double z = front + i * step, slope = flux / (h * h * h);
        const double h_mid = h + 0.5 * step * slope, flux_mid = flux - 0.25 * step * z * slope;
        const double slope_mid = flux_mid / (h_mid * h_mid * h_mid);
        h += step * slope_mid;
        flux -= 0.5 * step * (z + 0.5 * step) * slope_mid;
    }
    return h;
}

}  // namespace

double TensionFront::rate() const {
    const auto square_at = [](double front, double direction) {
        const double at_front =
            root_of([&](double edge) { return far_thickness(edge, front, direction) - 1.0; }, 0.2, 5.0);
        return at_front * at_front;
    };
    const double front = root_of(
        [&](double z) {
            return square_at(z, 1.0) - square_at(z, -1.0) - 3.0 * tension_step / (gravity * h * h);
        },
        0.0, 1.0);
    return front * std::sqrt(gravity * h * h * h / (3.0 * viscosity));
}

double yielded_tail(double force, double yield, double viscosity, double x, double t) {
    const double stands = yield / force;
    if (x <= 0) return stands;
    return 0.5 * (stands + std::sqrt(stands * stands + 4 * x * viscosity / (force * t)));
}

}  // namespace pastoso::film::validation

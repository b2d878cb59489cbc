#include "brush/pen_curve.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::brush {
namespace {

/// Longest tangent against the chord.
constexpr double kLongestTangent = 1.5;
constexpr double kLeastInterval_s = 1e-9;

double rate(const PenSample& before, const PenSample& after, double PenSample::*value) {
    return (after.*value - before.*value) / std::max(after.time_s - before.time_s, kLeastInterval_s);
}

double limited(double tangent, double chord) {
    const double longest = kLongestTangent * std::abs(chord);
    return std::clamp(tangent, -longest, longest);
}

/// Hermite's cubic at t in [0, 1], tangents with respect to t.
double hermite(double from, double tangent_from, double to, double tangent_to, double t) {
    const double t2 = t * t, t3 = t2 * t;
    return (2.0 * t3 - 3.0 * t2 + 1.0) * from + (t3 - 2.0 * t2 + t) * tangent_from +
           (3.0 * t2 - 2.0 * t3) * to + (t3 - t2) * tangent_to;
}

}  // namespace

PenCurve::PenCurve(const PenSample& before, const PenSample& from, const PenSample& to,
                   const PenSample& after)
    : from_(from), to_(to) {
    const double interval_s = to.time_s - from.time_s;
    const double chord_mm = std::hypot(to.x_mm - from.x_mm, to.y_mm - from.y_mm);
    const auto tangent = [&](const PenSample& first, const PenSample& last) {
        const Vector way = {rate(first, last, &PenSample::x_mm) * interval_s,
                            rate(first, last, &PenSample::y_mm) * interval_s};
        const double length_mm = std::hypot(way.x, way.y), longest_mm = kLongestTangent * chord_mm;
        const double share = length_mm > longest_mm ? longest_mm / length_mm : 1.0;
        return Vector{way.x * share, way.y * share};
    };
    tangent_from_ = tangent(before, to);
    tangent_to_ = tangent(from, after);
    for (std::size_t i = 0; i < kScalars.size(); ++i) {
        const double change = to.*kScalars[i] - from.*kScalars[i];
        scalar_from_[i] = limited(rate(before, to, kScalars[i]) * interval_s, change);
        scalar_to_[i] = limited(rate(from, after, kScalars[i]) * interval_s, change);
    }
}

PenSample PenCurve::at(double t) const {
    PenSample result = between(from_, to_, t);
    result.x_mm = hermite(from_.x_mm, tangent_from_.x, to_.x_mm, tangent_to_.x, t);
    result.y_mm = hermite(from_.y_mm, tangent_from_.y, to_.y_mm, tangent_to_.y, t);
    for (std::size_t i = 0; i < kScalars.size(); ++i) {
        result.*kScalars[i] =
            hermite(from_.*kScalars[i], scalar_from_[i], to_.*kScalars[i], scalar_to_[i], t);
    }
    result.pressure = std::clamp(result.pressure, 0.0, 1.0);
    return result;
}

PenSample between(const PenSample& from, const PenSample& to, double t) {
    PenSample result;
    for (const auto value :
         {&PenSample::time_s, &PenSample::x_mm, &PenSample::y_mm, &PenSample::pressure,
          &PenSample::tilt_x_deg, &PenSample::tilt_y_deg, &PenSample::rotation_deg, &PenSample::wheel})
        result.*value = from.*value + t * (to.*value - from.*value);
    return result;
}

double mean_speed_mm_s(const PenSample& from, const PenSample& to) {
    return std::hypot(rate(from, to, &PenSample::x_mm), rate(from, to, &PenSample::y_mm));
}

}  // namespace pastoso::brush

#include "brush/stroke_path.hpp"

#include "core/check.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pastoso::brush {
namespace {

constexpr std::array kScalars = {&PenSample::pressure, &PenSample::tilt_x_deg, &PenSample::tilt_y_deg,
                                 &PenSample::rotation_deg};

/// Longest tangent of a piece against its chord. After a pause the finite difference in time can be much
/// longer, and the curve would swing back before it starts.
constexpr double kLongestTangent = 1.5;

struct Vector {
    double x, y;
};

/// Straight parts that a curved piece is cut into, per step of the brush.
constexpr double kPartsPerStep = 2.5;

double length(const Vector& v) {
    return std::hypot(v.x, v.y);
}

Vector position(const PenSample& sample) {
    return {sample.x_mm, sample.y_mm};
}

Vector velocity_mm_s(const PenSample& before, const PenSample& after) {
    const double interval_s = std::max(after.time_s - before.time_s, 1e-9);
    return {(after.x_mm - before.x_mm) / interval_s, (after.y_mm - before.y_mm) / interval_s};
}

double rate(const PenSample& before, const PenSample& after, double PenSample::*value) {
    return (after.*value - before.*value) / std::max(after.time_s - before.time_s, 1e-9);
}

Vector limited(Vector tangent, double chord) {
    const double length = std::hypot(tangent.x, tangent.y);
    const double longest = kLongestTangent * chord;
    const double share = length > longest ? longest / length : 1.0;
    return {tangent.x * share, tangent.y * share};
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

PenSample between(const PenSample& from, const PenSample& to, double t) {
    PenSample result;
    result.time_s = from.time_s + t * (to.time_s - from.time_s);
    result.x_mm = from.x_mm + t * (to.x_mm - from.x_mm);
    result.y_mm = from.y_mm + t * (to.y_mm - from.y_mm);
    for (const auto value : kScalars)
        result.*value = from.*value + t * (to.*value - from.*value);
    return result;
}

/// The piece between two samples as a function of t in [0, 1].
struct Piece {
    PenSample from, to;
    Vector tangent_from, tangent_to;
    std::array<double, kScalars.size()> scalar_from, scalar_to;

    Piece(const PenSample& before, const PenSample& start, const PenSample& stop, const PenSample& after)
        : from(start), to(stop) {
        const double interval_s = to.time_s - from.time_s;
        const double chord = std::hypot(to.x_mm - from.x_mm, to.y_mm - from.y_mm);
        const Vector leaving = velocity_mm_s(before, to), arriving = velocity_mm_s(from, after);
        tangent_from = limited({leaving.x * interval_s, leaving.y * interval_s}, chord);
        tangent_to = limited({arriving.x * interval_s, arriving.y * interval_s}, chord);
        for (std::size_t i = 0; i < kScalars.size(); ++i) {
            const double change = to.*kScalars[i] - from.*kScalars[i];
            scalar_from[i] = limited(rate(before, to, kScalars[i]) * interval_s, change);
            scalar_to[i] = limited(rate(from, after, kScalars[i]) * interval_s, change);
        }
    }

    PenSample at(double t) const {
        PenSample result = between(from, to, t);
        const Vector a = position(from), b = position(to);
        result.x_mm = hermite(a.x, tangent_from.x, b.x, tangent_to.x, t);
        result.y_mm = hermite(a.y, tangent_from.y, b.y, tangent_to.y, t);
        for (std::size_t i = 0; i < kScalars.size(); ++i) {
            result.*kScalars[i] =
                hermite(from.*kScalars[i], scalar_from[i], to.*kScalars[i], scalar_to[i], t);
        }
        result.pressure = std::clamp(result.pressure, 0.0, 1.0);
        return result;
    }
};

}  // namespace

void StrokePath::begin(const PenSample& sample, double direction_x, double direction_y) {
    samples_ = {sample};
    since_step_mm_ = 0.0;
    at_ = {sample, direction_x, direction_y, 0.0};
    at_.pen.pressure = 0.0;
    run_straight(sample, 0.0);
}

void StrokePath::add(const PenSample& sample) {
    PASTOSO_CHECK(!samples_.empty());
    PASTOSO_CHECK_OP(sample.time_s, >, samples_.back().time_s);
    run_last_piece(sample);
    if (samples_.size() == 3) samples_.erase(samples_.begin());
    samples_.push_back(sample);
}

void StrokePath::end() {
    PASTOSO_CHECK(!samples_.empty());
    run_last_piece(samples_.back());
    samples_.clear();
}

std::vector<PathStep> StrokePath::take_steps() {
    return std::exchange(steps_, {});
}

void StrokePath::run_last_piece(const PenSample& after) {
    const std::size_t count = samples_.size();
    if (count < 2) return;
    const PenSample &from = samples_[count - 2], &to = samples_[count - 1];
    const PenSample& before = count == 3 ? samples_[0] : from;
    const Piece piece(before, from, to, after);
    const double speed_from = length(velocity_mm_s(before, to)),
                 speed_to = length(velocity_mm_s(from, after));
    const double parts = std::ceil(kPartsPerStep * length_mm(from, to) / measure_.step_mm);
    for (double part = 1.0; part <= parts; ++part) {
        const double t = part / parts;
        run_straight(piece.at(t), speed_from + t * (speed_to - speed_from));
    }
}

void StrokePath::run_straight(const PenSample& to, double speed_mm_s) {
    const PenSample from = at_.pen;
    const Vector way = {to.x_mm - from.x_mm, to.y_mm - from.y_mm};
    const double travelled_mm = length(way);
    if (travelled_mm > 0.0) {
        at_.direction_x = way.x / travelled_mm;
        at_.direction_y = way.y / travelled_mm;
    }
    at_.speed_mm_s = speed_mm_s;
    const double whole_mm = length_mm(from, to);
    double done_mm = measure_.step_mm - since_step_mm_;
    for (; done_mm <= whole_mm; done_mm += measure_.step_mm) {
        at_.pen = between(from, to, done_mm / whole_mm);
        steps_.push_back(at_);
    }
    since_step_mm_ = whole_mm - (done_mm - measure_.step_mm);
    at_.pen = to;
}

double StrokePath::length_mm(const PenSample& from, const PenSample& to) const {
    const double slide_mm = measure_.press_slide_mm * (to.pressure - from.pressure);
    const double turn_mm = measure_.turn_radius_mm * core::radians(to.rotation_deg - from.rotation_deg);
    return std::hypot(length({to.x_mm - from.x_mm, to.y_mm - from.y_mm}), slide_mm, turn_mm);
}

}  // namespace pastoso::brush

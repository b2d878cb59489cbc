#include "brush/stroke_path.hpp"

#include "brush/pen_curve.hpp"
#include "core/check.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pastoso::brush {
namespace {

/// Straight parts that a curved piece is cut into, per step of the brush.
constexpr double kPartsPerStep = 2.5;

}  // namespace

void StrokePath::begin(const PenSample& sample, double direction_x, double direction_y) {
    samples_ = {sample};
    since_step_mm_ = travelled_mm_ = 0.0;
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
    const PenCurve piece(before, from, to, after);
    const double speed_from = mean_speed_mm_s(before, to), speed_to = mean_speed_mm_s(from, after);
    const double parts = std::ceil(kPartsPerStep * length_mm(from, to) / measure_.step_mm);
    for (double part = 1.0; part <= parts; ++part) {
        const double t = part / parts;
        run_straight(piece.at(t), speed_from + t * (speed_to - speed_from));
    }
}

void StrokePath::run_straight(const PenSample& to, double speed_mm_s) {
    const PenSample from = at_.pen;
    const double way_x_mm = to.x_mm - from.x_mm, way_y_mm = to.y_mm - from.y_mm;
    const double travelled_mm = std::hypot(way_x_mm, way_y_mm);
    if (travelled_mm > 0.0) {
        at_.direction_x = way_x_mm / travelled_mm;
        at_.direction_y = way_y_mm / travelled_mm;
    }
    at_.speed_mm_s = speed_mm_s;
    const double before_mm = std::exchange(travelled_mm_, travelled_mm_ + travelled_mm);
    const double whole_mm = length_mm(from, to);
    double done_mm = measure_.step_mm - since_step_mm_;
    for (; done_mm <= whole_mm; done_mm += measure_.step_mm) {
        at_.pen = between(from, to, done_mm / whole_mm);
        at_.travelled_mm = before_mm + travelled_mm * (done_mm / whole_mm);
        steps_.push_back(at_);
    }
    since_step_mm_ = whole_mm - (done_mm - measure_.step_mm);
    at_.pen = to;
}

double StrokePath::length_mm(const PenSample& from, const PenSample& to) const {
    const double slide_mm = measure_.press_slide_mm * (to.pressure - from.pressure);
    const double turn_mm = measure_.turn_radius_mm * core::radians(to.rotation_deg - from.rotation_deg);
    const double catches_up_mm = std::max(0.0, trail_mm(from.pressure) - trail_mm(to.pressure));
    const double way_mm = std::hypot(to.x_mm - from.x_mm, to.y_mm - from.y_mm) + catches_up_mm;
    return std::hypot(way_mm, slide_mm, turn_mm);
}

double StrokePath::trail_mm(double pressure) const {
    if (pressure <= 0.0) return 0.0;
    const double stiffness = measure_.stiff_end_pressure / pressure;
    const double trail_mm = measure_.trail_mm * std::sqrt(pressure) / (1.0 + stiffness * stiffness);
    return std::min(trail_mm, travelled_mm_);
}

}  // namespace pastoso::brush

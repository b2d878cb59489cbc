#include "brush/pen_guide.hpp"

#include "core/check.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::brush {
namespace {

/// Nearer to the centre than this share of an ellipse's half axes, a place has no direction.
constexpr double kNoDirection = 1e-9;

struct Vector {
    double x = 0.0, y = 0.0;
};

PenSample moved(PenSample sample, const Vector& place) {
    sample.x_mm = place.x;
    sample.y_mm = place.y;
    return sample;
}

/// Turns the brush across a direction, the shorter way from how it stood before.
PenSample turned_across(PenSample sample, const Vector& direction, double before_deg) {
    const double across_deg = core::degrees(std::atan2(direction.y, direction.x)) - 90.0;
    sample.rotation_deg = before_deg + std::remainder(across_deg - before_deg, 180.0);
    return sample;
}

struct Follower {
    const PenGuide& guide;
    const PenSample &down, &before, &sample;

    PenSample operator()(std::monostate) const { return sample; }
    PenSample operator()(const StraightLine&) const { return sample; }
    PenSample operator()(const Ruler& ruler) const;
    PenSample operator()(const EllipseCurve& ellipse) const;

    PenSample result(const Vector& place, const Vector& direction) const {
        const PenSample led = moved(sample, place);
        return guide.turn_across ? turned_across(led, direction, before.rotation_deg) : led;
    }
};

PenSample Follower::operator()(const Ruler& ruler) const {
    const Vector whole = {ruler.x2_mm - ruler.x1_mm, ruler.y2_mm - ruler.y1_mm};
    const double length_mm = std::hypot(whole.x, whole.y);
    PASTOSO_CHECK_OP(length_mm, >, 0.0);
    const Vector along = {whole.x / length_mm, whole.y / length_mm};
    const auto beside_mm = [&](const PenSample& pen) {
        return (pen.y_mm - ruler.y1_mm) * along.x - (pen.x_mm - ruler.x1_mm) * along.y;
    };
    const double start_mm = beside_mm(down);
    const double wanted_mm = std::abs(start_mm) <= guide.reach_mm ? 0.0 : start_mm;
    const double away_mm = wanted_mm - beside_mm(sample);
    return result({sample.x_mm - along.y * away_mm, sample.y_mm + along.x * away_mm}, along);
}

/// Lengths in an ellipse's frame, in units of its half axes.
struct EllipseFrame {
    const EllipseCurve& ellipse;
    double cos_turn = std::cos(core::radians(ellipse.turn_deg));
    double sin_turn = std::sin(core::radians(ellipse.turn_deg));

    Vector units(const PenSample& pen) const {
        const double x = pen.x_mm - ellipse.centre_x_mm, y = pen.y_mm - ellipse.centre_y_mm;
        return {(x * cos_turn + y * sin_turn) / ellipse.half_width_mm,
                (y * cos_turn - x * sin_turn) / ellipse.half_height_mm};
    }
    Vector turned_back(const Vector& units) const {
        const double x = units.x * ellipse.half_width_mm, y = units.y * ellipse.half_height_mm;
        return {x * cos_turn - y * sin_turn, x * sin_turn + y * cos_turn};
    }
};

PenSample Follower::operator()(const EllipseCurve& ellipse) const {
    const EllipseFrame frame{ellipse};
    const auto radius = [&](const PenSample& pen) {
        const Vector units = frame.units(pen);
        return std::hypot(units.x, units.y);
    };
    const double start = radius(down);
    const double smaller_mm = std::min(ellipse.half_width_mm, ellipse.half_height_mm);
    const double wanted = std::abs(start - 1.0) * smaller_mm <= guide.reach_mm ? 1.0 : start;
    Vector units = frame.units(sample);
    double length = std::hypot(units.x, units.y);
    if (length < kNoDirection) {
        units = frame.units(before);
        length = std::hypot(units.x, units.y);
    }
    if (length < kNoDirection) {
        units = {1.0, 0.0};
        length = 1.0;
    }
    const Vector unit = {units.x / length, units.y / length};
    const Vector place = frame.turned_back({wanted * unit.x, wanted * unit.y});
    return result({ellipse.centre_x_mm + place.x, ellipse.centre_y_mm + place.y},
                  frame.turned_back({-unit.y, unit.x}));
}

/// The share of the way from `from` to `to` at which the sample stands.
double share_of_segment(const PenSample& sample, const PenSample& from, const PenSample& to) {
    const double x = to.x_mm - from.x_mm, y = to.y_mm - from.y_mm;
    const double length2 = x * x + y * y;
    if (length2 <= 0.0) return 0.0;
    return std::clamp(((sample.x_mm - from.x_mm) * x + (sample.y_mm - from.y_mm) * y) / length2, 0.0,
                      1.0);
}

PenSample at_share(const PenSample& sample, const PenSample& from, const PenSample& to, double share) {
    return moved(sample, {std::lerp(from.x_mm, to.x_mm, share), std::lerp(from.y_mm, to.y_mm, share)});
}

}  // namespace

PenSample guided(const PenGuide& guide, const PenSample& down, const PenSample& before,
                 const PenSample& sample) {
    return std::visit(Follower{guide, down, before, sample}, guide.form);
}

PenSample on_segment(const PenSample& sample, const PenSample& from, const PenSample& to) {
    return at_share(sample, from, to, share_of_segment(sample, from, to));
}

std::vector<PenSample> straightened(std::vector<PenSample> samples, bool turn_across) {
    PASTOSO_CHECK(!samples.empty());
    const PenSample from = samples.front(), to = samples.back();
    const Vector way = {to.x_mm - from.x_mm, to.y_mm - from.y_mm};
    const bool turns = turn_across && std::hypot(way.x, way.y) > 0.0;
    double share = 0.0;
    for (PenSample& sample : samples) {
        share = std::max(share, share_of_segment(sample, from, to));
        sample = at_share(sample, from, to, share);
        if (turns) sample = turned_across(sample, way, from.rotation_deg);
    }
    return samples;
}

}  // namespace pastoso::brush

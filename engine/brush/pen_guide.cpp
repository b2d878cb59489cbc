#include "brush/pen_guide.hpp"

#include "core/check.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
    PenSample operator()(const VanishingPoints&) const { return sample; }
    PenSample operator()(const Grid&) const { return sample; }
    PenSample operator()(const Ruler& ruler) const;
    PenSample operator()(const EllipseCurve& ellipse) const;

    PenSample result(const Vector& place, const Vector& direction) const {
        const PenSample led = moved(sample, {std::lerp(sample.x_mm, place.x, guide.strength),
                                             std::lerp(sample.y_mm, place.y, guide.strength)});
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

/// The rulers that a stroke which starts at `down` may keep to.
struct Rulers {
    const PenSample& down;
    double reach_mm;

    std::vector<Ruler> operator()(const auto&) const { return {}; }
    std::vector<Ruler> operator()(const VanishingPoints& points) const;
    std::vector<Ruler> operator()(const Grid& grid) const;

    Ruler from_down(const Vector& way) const {
        return {down.x_mm, down.y_mm, down.x_mm + way.x, down.y_mm + way.y};
    }
};

/// Long beside what the sums of millimetres are rounded to.
constexpr double kRulerLength_mm = 100.0;

Vector way_mm(double direction_deg) {
    return {kRulerLength_mm * std::cos(core::radians(direction_deg)),
            kRulerLength_mm * std::sin(core::radians(direction_deg))};
}

/// Nearer to a vanishing point no direction leads there.
constexpr double kAtPoint_mm = 0.01;

std::vector<Ruler> Rulers::operator()(const VanishingPoints& points) const {
    const Vector all[] = {
        {points.x1_mm, points.y1_mm}, {points.x2_mm, points.y2_mm}, {points.x3_mm, points.y3_mm}};
    std::vector<Ruler> rulers;
    for (int i = 0; i < points.count; ++i) {
        const Vector way = {all[i].x - down.x_mm, all[i].y - down.y_mm};
        if (std::hypot(way.x, way.y) >= kAtPoint_mm) rulers.push_back(from_down(way));
    }
    if (points.count < 2) rulers.push_back(from_down(way_mm(points.level_deg)));
    if (points.count < 3) rulers.push_back(from_down(way_mm(points.upright_deg)));
    return rulers;
}

std::vector<Ruler> Rulers::operator()(const Grid& grid) const {
    const auto along = [&](double direction_deg, double spacing_mm) {
        const Vector way = way_mm(direction_deg);
        const Vector across = {-way.y / kRulerLength_mm, way.x / kRulerLength_mm};
        const double beside_mm = (down.x_mm - grid.x_mm) * across.x + (down.y_mm - grid.y_mm) * across.y;
        const double off_mm = beside_mm - spacing_mm * std::round(beside_mm / spacing_mm);
        Ruler ruler = from_down(way);
        if (std::abs(off_mm) > reach_mm) return ruler;
        ruler.x1_mm -= off_mm * across.x;
        ruler.y1_mm -= off_mm * across.y;
        ruler.x2_mm -= off_mm * across.x;
        ruler.y2_mm -= off_mm * across.y;
        return ruler;
    };
    return {along(grid.direction_deg, grid.spacing_mm),
            along(grid.other_direction_deg, grid.other_spacing_mm)};
}

/// How far the hand's way goes along a ruler, either way.
double way_along(const Ruler& ruler, const Vector& way) {
    const double x = ruler.x2_mm - ruler.x1_mm, y = ruler.y2_mm - ruler.y1_mm;
    return std::abs(x * way.x + y * way.y) / std::hypot(x, y);
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
    if (guide.strength == 0.0) return sample;
    return std::visit(Follower{guide, down, before, sample}, guide.form);
}

PenGuide chosen_for_stroke(const PenGuide& guide, const PenSample& down, const PenSample& now) {
    PenGuide chosen = guide;
    chosen.form = {};
    chosen.reach_mm = std::numeric_limits<double>::infinity();
    const Vector way = {now.x_mm - down.x_mm, now.y_mm - down.y_mm};
    if (way.x == 0.0 && way.y == 0.0) return chosen;
    double furthest_mm = -1.0;
    for (const Ruler& ruler : std::visit(Rulers{down, guide.reach_mm}, guide.form)) {
        const double along_mm = way_along(ruler, way);
        if (along_mm <= furthest_mm) continue;
        furthest_mm = along_mm;
        chosen.form = ruler;
    }
    return chosen;
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

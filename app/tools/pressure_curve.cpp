#include "tools/pressure_curve.hpp"

#include "brush/hand_pose.hpp"

#include <algorithm>

namespace pastoso::tools {
namespace {

using brush::CurvePoint;

constexpr CurveFrame kFrame{1.0, 0.0, 1.0};

}  // namespace

brush::DynamicsCurve ready_curve(ReadyCurve which) {
    brush::DynamicsCurve curve;
    switch (which) {
        case ReadyCurve::Soft:
            curve.points = {{0.0, 0.0}, {0.25, 0.45}, {0.5, 0.72}, {0.75, 0.89}, {1.0, 1.0}};
            break;
        case ReadyCurve::Linear:
            curve.points = {{0.0, 0.0}, {1.0, 1.0}};
            break;
        case ReadyCurve::Firm:
            curve.points = {{0.0, 0.0}, {0.25, 0.08}, {0.5, 0.25}, {0.75, 0.54}, {1.0, 1.0}};
            break;
    }
    return curve;
}

bool is_pressure_curve(const CurvePoints& points) {
    const auto in_frame = [](const CurvePoint& point) {
        return point.input >= 0.0 && point.input <= 1.0 && point.output >= 0.0 && point.output <= 1.0;
    };
    const auto stops_rising = [](const CurvePoint& a, const CurvePoint& b) {
        return b.input <= a.input || b.output < a.output;
    };
    return points.size() >= 2 && points.front().input == 0.0 && points.back().input == 1.0 &&
           std::all_of(points.begin(), points.end(), in_frame) &&
           std::adjacent_find(points.begin(), points.end(), stops_rising) == points.end();
}

double mapped_pressure(const brush::DynamicsCurve& curve, double told) {
    // What is no number is no pressure either.
    const double pressure = told > 0.0 ? std::min(told, 1.0) : 0.0;
    return std::clamp(brush::evaluate(curve, pressure), 0.0, 1.0);
}

CurvePoint confined_rising(const CurvePoints& points, int index, const CurvePoint& place) {
    CurvePoint there = confined(points, index, place, kFrame);
    const auto i = static_cast<std::size_t>(index);
    const bool is_first = i == 0, is_last = i + 1 == points.size();
    if (is_first || is_last) there.input = points[i].input;
    const double low = is_first ? 0.0 : points[i - 1].output;
    const double high = is_last ? 1.0 : points[i + 1].output;
    there.output = std::clamp(there.output, low, high);
    return there;
}

int add_rising(CurvePoints& points, const CurvePoint& place) {
    const int added = add_point(points, place, kFrame);
    if (added < 0) return added;
    const auto i = static_cast<std::size_t>(added);
    points[i] = confined_rising(points, added, points[i]);
    return added;
}

}  // namespace pastoso::tools

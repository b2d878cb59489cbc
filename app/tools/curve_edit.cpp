#include "tools/curve_edit.hpp"

#include "brush/preset_names.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pastoso::tools {
namespace {

using brush::CurvePoint;
using brush::DynamicsInput;
using brush::DynamicsTarget;

double usual_input(DynamicsInput input) {
    switch (input) {
        case DynamicsInput::Tilt:
            return 90.0;
        case DynamicsInput::BarrelRotation:
        case DynamicsInput::Direction:
            return 360.0;
        case DynamicsInput::Speed:
            return 500.0;
        case DynamicsInput::Distance:
            return 200.0;
        case DynamicsInput::Time:
            return 5.0;
        case DynamicsInput::Fade:
            return 20.0;
        default:
            return 1.0;
    }
}

double usual_output(DynamicsTarget target) {
    switch (target) {
        case DynamicsTarget::Press:
        case DynamicsTarget::Lean:
            return 1.0;
        case DynamicsTarget::Rotation:
            return 360.0;
        default:
            return 2.0;
    }
}

}  // namespace

CurveFrame frame_of(const brush::DynamicsCurve& curve) {
    CurveFrame frame{usual_input(curve.input), 0.0, usual_output(curve.target)};
    for (const CurvePoint& point : curve.points) {
        frame.most_input = std::max(frame.most_input, point.input);
        frame.most_output = std::max(frame.most_output, point.output);
        frame.least_output = std::min(frame.least_output, point.output);
    }
    return frame;
}

CurvePoint confined(const CurvePoints& points, int index, const CurvePoint& place,
                    const CurveFrame& frame) {
    const double gap = kLeastGap * frame.most_input;
    const auto i = static_cast<std::size_t>(index);
    const double low = i == 0 ? 0.0 : points[i - 1].input + gap;
    const double high = i + 1 < points.size() ? points[i + 1].input - gap : frame.most_input;
    return {std::clamp(place.input, std::min(low, high), high),
            std::clamp(place.output, frame.least_output, frame.most_output)};
}

int add_point(CurvePoints& points, const CurvePoint& place, const CurveFrame& frame) {
    if (points.size() >= brush::kMostCurvePoints) return -1;
    const double gap = kLeastGap * frame.most_input;
    const double input = std::clamp(place.input, 0.0, frame.most_input);
    const bool taken = std::any_of(points.begin(), points.end(), [&](const CurvePoint& point) {
        return std::abs(point.input - input) < gap;
    });
    if (taken) return -1;
    const auto after = std::find_if(points.begin(), points.end(),
                                    [&](const CurvePoint& point) { return point.input > input; });
    const double output = std::clamp(place.output, frame.least_output, frame.most_output);
    const auto index = after - points.begin();
    points.insert(after, {input, output});
    return static_cast<int>(index);
}

namespace {

bool sets(const Curves& curves, DynamicsTarget target) {
    return std::any_of(curves.begin(), curves.end(),
                       [&](const brush::DynamicsCurve& curve) { return curve.target == target; });
}

/// What sets it in a tool without a curve, besides the lean.
std::optional<DynamicsInput> own_input(DynamicsTarget target) {
    if (target == DynamicsTarget::Press) return DynamicsInput::Pressure;
    if (target == DynamicsTarget::Rotation) return DynamicsInput::BarrelRotation;
    return std::nullopt;
}

/// What a tool without a curve does (brush/hand_pose.hpp); the lean is the tangent of the tilt.
CurvePoints unchanged(DynamicsInput input, DynamicsTarget target, bool first_of_target) {
    if (target == DynamicsTarget::Rotation) {
        if (first_of_target) return {{0.0, 0.0}, {360.0, 360.0}};
        return {{0.0, 0.0}, {usual_input(input), 0.0}};
    }
    if (target == DynamicsTarget::Lean && first_of_target)
        return {{0.0, 0.0}, {15.0, 0.27}, {30.0, 0.58}, {45.0, 1.0}, {60.0, 1.73}, {75.0, 3.73}};
    if (target == DynamicsTarget::Press && first_of_target) return {{0.0, 0.0}, {1.0, 1.0}};
    return {{0.0, 1.0}, {usual_input(input), 1.0}};
}

}  // namespace

bool matters(DynamicsInput input, DynamicsTarget target, brush::ToolKind kind) {
    if (!brush::can_set(input, target)) return false;
    const bool touches = kind == brush::ToolKind::Contact;
    switch (target) {
        case DynamicsTarget::Press:
        case DynamicsTarget::Lean:
        case DynamicsTarget::Rotation:
            return true;
        case DynamicsTarget::Flow:
        case DynamicsTarget::Spread:
            return !touches;
        default:
            return touches;
    }
}

int find_curve(const Curves& curves, DynamicsInput input, DynamicsTarget target) {
    const auto found =
        std::find_if(curves.begin(), curves.end(), [&](const brush::DynamicsCurve& curve) {
            return curve.input == input && curve.target == target;
        });
    return found == curves.end() ? -1 : static_cast<int>(found - curves.begin());
}

int add_curve(Curves& curves, DynamicsInput input, DynamicsTarget target) {
    const auto own = own_input(target);
    if (own && input != *own && !sets(curves, target)) add_curve(curves, *own, target);
    curves.push_back({input, target, unchanged(input, target, !sets(curves, target))});
    return static_cast<int>(curves.size()) - 1;
}

void remove_point(CurvePoints& points, int index) {
    if (points.size() > 1) points.erase(points.begin() + index);
}

}  // namespace pastoso::tools

#include "brush/hand_pose.hpp"

#include "brush/smooth_noise.hpp"
#include "core/random.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pastoso::brush {
namespace {

constexpr double kSteepestTilt_deg = 85.0;

/// The tilt as a vector of tangents, and as an angle.
struct Tilt {
    double tangent_x, tangent_y, angle_deg;
};

Tilt tilt_of(const PenSample& pen) {
    const auto tangent = [](double angle_deg) {
        return std::tan(core::radians(std::clamp(angle_deg, -kSteepestTilt_deg, kSteepestTilt_deg)));
    };
    const double x = tangent(pen.tilt_x_deg), y = tangent(pen.tilt_y_deg);
    return {x, y, core::degrees(std::atan(std::hypot(x, y)))};
}

double direction_deg(const PathStep& step) {
    const double degrees = core::degrees(std::atan2(step.direction_y, step.direction_x));
    return degrees < 0.0 ? degrees + 360.0 : degrees;
}

/// 0 to 1, independent of the brush's other random numbers.
double stroke_random(std::uint32_t seed) {
    constexpr std::uint32_t kStream = 0x51D0;
    return core::uniform_noise(seed, kStream);
}

double dab_random(const PathStep& step, const StrokeState& stroke) {
    constexpr std::uint32_t kStream = 0x51D1;
    return 0.5 + 0.5 * smooth_noise(2.0 * step.travelled_mm / stroke.width_mm, stroke.seed + kStream);
}

}  // namespace

double input_value(DynamicsInput input, const PathStep& step, const StrokeState& stroke) {
    switch (input) {
        case DynamicsInput::Pressure:
            return step.pen.pressure;
        case DynamicsInput::Tilt:
            return tilt_of(step.pen).angle_deg;
        case DynamicsInput::BarrelRotation:
            return step.pen.rotation_deg - 360.0 * std::floor(step.pen.rotation_deg / 360.0);
        case DynamicsInput::Speed:
            return step.speed_mm_s;
        case DynamicsInput::Direction:
            return direction_deg(step);
        case DynamicsInput::Distance:
            return step.travelled_mm;
        case DynamicsInput::Time:
            return step.pen.time_s - stroke.begun_s;
        case DynamicsInput::Fade:
            return step.travelled_mm / stroke.width_mm;
        case DynamicsInput::StrokeRandom:
            return stroke_random(stroke.seed);
        case DynamicsInput::DabRandom:
            return dab_random(step, stroke);
        case DynamicsInput::Wheel:
            return 0.5 + 0.5 * step.pen.wheel;
        case DynamicsInput::Load:
            return stroke.fill;
    }
    return 0.0;
}

bool reads(const std::vector<DynamicsCurve>& dynamics, DynamicsInput input) {
    return std::any_of(dynamics.begin(), dynamics.end(),
                       [input](const DynamicsCurve& curve) { return curve.input == input; });
}

double evaluate(const DynamicsCurve& curve, double input) {
    const auto& points = curve.points;
    const auto after = std::find_if(points.begin(), points.end(),
                                    [&](const CurvePoint& point) { return point.input > input; });
    if (after == points.begin()) return points.front().output;
    if (after == points.end()) return points.back().output;
    const CurvePoint &a = after[-1], &b = *after;
    return a.output + (b.output - a.output) * (input - a.input) / (b.input - a.input);
}

HandPose hand_pose(const std::vector<DynamicsCurve>& dynamics, const PathStep& step,
                   const StrokeState& stroke) {
    const Tilt tilt = tilt_of(step.pen);
    HandPose pose;
    std::optional<double> press, lean, rotation_deg;
    for (const DynamicsCurve& curve : dynamics) {
        const double value = evaluate(curve, input_value(curve.input, step, stroke));
        switch (curve.target) {
            case DynamicsTarget::Press:
                press = press.value_or(1.0) * value;
                break;
            case DynamicsTarget::Lean:
                lean = lean.value_or(1.0) * value;
                break;
            case DynamicsTarget::Rotation:
                rotation_deg = rotation_deg.value_or(0.0) + value;
                break;
            case DynamicsTarget::Reach:
                pose.reach *= std::max(value, 0.0);
                break;
            case DynamicsTarget::Film:
                pose.film *= std::max(value, 0.0);
                break;
            case DynamicsTarget::Pickup:
                pose.pickup *= std::max(value, 0.0);
                break;
            case DynamicsTarget::Flow:
                pose.flow *= std::max(value, 0.0);
                break;
            case DynamicsTarget::Spread:
                pose.spread *= std::max(value, 0.0);
                break;
            case DynamicsTarget::Ride:
                pose.ride *= std::max(value, 0.0);
                break;
        }
    }
    const double tangent = std::hypot(tilt.tangent_x, tilt.tangent_y);
    const double lean_factor = tangent > 0.0 ? lean.value_or(tangent) / tangent : 0.0;
    const double rotation = core::radians(rotation_deg.value_or(step.pen.rotation_deg));
    pose.x_mm = step.pen.x_mm;
    pose.y_mm = step.pen.y_mm;
    pose.travel_x = step.direction_x;
    pose.travel_y = step.direction_y;
    pose.speed_mm_s = step.speed_mm_s;
    pose.press = std::clamp(press.value_or(step.pen.pressure), 0.0, 1.0);
    pose.lean_x = tilt.tangent_x * lean_factor;
    pose.lean_y = tilt.tangent_y * lean_factor;
    pose.cos_rotation = std::cos(rotation);
    pose.sin_rotation = std::sin(rotation);
    return pose;
}

}  // namespace pastoso::brush

// What the hand does to the brush at one step of the path: the preset's dynamics curves applied.
#pragma once

#include "brush/preset.hpp"
#include "brush/stroke_path.hpp"

#include <cstdint>
#include <vector>

namespace pastoso::brush {

/// Value of a curve: linear between its points, constant beyond them.
double evaluate(const DynamicsCurve& curve, double input);

struct HandPose {
    double x_mm = 0.0, y_mm = 0.0;
    double travel_x = 0.0, travel_y = 1.0;  ///< direction of travel, unit length
    double speed_mm_s = 0.0;
    double press = 0.0;                 ///< 0 to 1
    double lean_x = 0.0, lean_y = 0.0;  ///< points where the pen leans
    double cos_rotation = 1.0, sin_rotation = 0.0;
    double rolled_mm = 0.0;  ///< how far a roller has turned
    /// Factors on the preset's numbers.
    double reach = 1.0, film = 1.0, pickup = 1.0, flow = 1.0, spread = 1.0, ride = 1.0;
};

/// What curves read besides the step.
struct StrokeState {
    double begun_s = 0.0;    ///< time when the pen came down
    double width_mm = 10.0;  ///< of the tip
    std::uint32_t seed = 0;  ///< of the stroke's random numbers
    double fill = 1.0;       ///< of the tool's capacity
};

/// What a curve of that input reads.
double input_value(DynamicsInput input, const PathStep& step, const StrokeState& stroke);

/// Whether some curve reads that.
bool reads(const std::vector<DynamicsCurve>& dynamics, DynamicsInput input);

/// Where no curve sets it, press is the pressure, lean the tangent of the tilt and rotation the
/// barrel's. Several curves with one target are multiplied (rotations: added).
HandPose hand_pose(const std::vector<DynamicsCurve>& dynamics, const PathStep& step,
                   const StrokeState& stroke = {});

}  // namespace pastoso::brush

// What a brush touches that is set down in one place: for those who show it before it paints.
#pragma once

#include "brush/hand_pose.hpp"
#include "brush/preset.hpp"
#include "brush/tip.hpp"

#include <vector>

#include <glm/vec2.hpp>

namespace pastoso::brush {

/// Bristles slide this share of the way that the ferrule is pressed down.
inline constexpr double kPressSlide = 0.4;

/// What a hair is pressed down by before its end lies down, in hair lengths: without that, tips that
/// are lifted would slide forward ever faster, and touch the canvas here and there.
inline constexpr double kStiffEnd = 0.03;

/// The tips of the bristles that touch a flat support when the hand sets the brush down so, before it
/// travels: from the pen, in millimetres. None for tools that touch nothing.
std::vector<glm::vec2> tips_set_down(const Preset& preset, const Tip& tip, const HandPose& hand);

}  // namespace pastoso::brush

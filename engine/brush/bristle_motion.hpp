// Where the bristles touch the canvas. Each is an inextensible hair of its own: pressed down by delta it
// bends and its tip reaches up to bend sqrt(delta (2 L - delta)) / (1 + (e L / delta)^2) from below its
// root, with e = 0.03 for the stiffness of its end. The tip stays where it is until the hair is taut and
// then trails (a tractrix), and springs back towards the side it leans to.
#pragma once

#include "brush/brush.hpp"
#include "brush/hand_pose.hpp"
#include "film/state.hpp"

#include <algorithm>
#include <vector>

namespace pastoso::brush {

/// The hairs of a bristle lie on what is highest within this many footprint radii.
inline constexpr double kTuft_radii = 0.5;

struct BristlePose {
    bool down = false;              ///< touches the canvas
    bool lifted = false;            ///< touched it in this stroke and does no more
    double x_mm = 0.0, y_mm = 0.0;  ///< of the tip; where it touched last
    float press = 0.0F;             ///< 0 to 1
    float support_mm = 0.0F;        ///< height of the dry surface below it
    float bearing_mm = 0.0F;        ///< height of what the tool bears on there (brush/bearing.hpp)
    float ride = 0.0F;              ///< 0: it bears on the dry surface, 1: on wet paint
    float freshness = 1.0F;         ///< 1 on touching down, falls to 0 along the stroke
};

/// What the touching bristles have in common. Sides are measured from the pen across the direction of
/// travel, positive to travel turned by +90 degrees (x towards y).
struct Swath {
    double low_mm = 0.0, high_mm = 0.0;  ///< how far the bristles reach to both sides
    float edge_support_mm = 0.0F;        ///< height of the dry surface that a stiff edge would lie on
};

/// Moves all bristles by one step of `step_mm` and lets those that touch follow the support: up at once,
/// down with the slope `descend` allows, so that light hairs skip the hollows of the weave.
Swath move_bristles(const Brush& brush, const HandPose& hand, double step_mm,
                    const film::FilmState& film, std::vector<BristlePose>& poses);

/// How much of its way hairs that are pressed so (0 to 1) force on paint: it is squeezed out to their
/// sides and pushed ahead by firm ones, and gives way to those that just touch.
inline float firmness(float press) {
    constexpr float kFirmPress = 0.2F;
    return std::min(1.0F, press / kFirmPress);
}

/// Position across the direction of travel, from the pen.
inline double side_mm(const BristlePose& pose, const HandPose& hand) {
    return (pose.y_mm - hand.y_mm) * hand.travel_x - (pose.x_mm - hand.x_mm) * hand.travel_y;
}

}  // namespace pastoso::brush

// What the painter holds and has laid out: the choices that outlive a stroke.
#pragma once

#include "document/events.hpp"

#include <optional>
#include <string>
#include <vector>

namespace pastoso::tools {

inline constexpr double kSmallestBrush_mm = 1.0;
inline constexpr double kLargestBrush_mm = 60.0;

struct Hand {
    std::string brush = "Flat bristle 20";
    double brush_width_mm = 20.0;
    document::PaintRecipe paint{{{"PB29", 1.0}}, 1.0};
    std::string medium = "heavy-body oil";
    document::TiltCanvas tilt{60.0, 90.0};
    film::DryingAir air;
    brush::Stabiliser stabiliser;
    brush::Symmetry symmetry;
    std::optional<brush::Ruler> ruler;  ///< lies on the canvas
    brush::PenGuide guide;              ///< that the latest stroke had
    bool reload_each_stroke = true;     ///< a clean brush full of `paint` at every touch
    bool turn_with_stroke = true;       ///< a pen that does not tell its rotation turns across its path
};

/// What the painter holds after these events, having held `hand` before. Throws InputError for an
/// unknown brush.
Hand hand_after(Hand hand, const std::vector<document::Event>& events);

/// The next width up or down a ladder of handy steps (about 12 %, at least half a millimetre), within
/// the limits.
double stepped_brush_width_mm(double width_mm, int steps);

}  // namespace pastoso::tools

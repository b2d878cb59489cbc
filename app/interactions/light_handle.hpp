// The lamp over the canvas: a handle on a round dial that lies in the middle of the window.
#pragma once

#include "screen/view_transform.hpp"
#include "shade/render.hpp"

#include <optional>

namespace pastoso::interactions {

/// As low as the handle goes, at the rim; in the middle the lamp stands above the canvas.
inline constexpr double kLowestLight_deg = 8.0;

struct LightDirection {
    double azimuth_deg = 0.0;  ///< as shade::Lighting has it: 90 is the canvas's upper edge
    double elevation_deg = 0.0;
};

struct LightDial {
    glm::dvec2 centre_px{};
    double radius_px = 1.0;
};

/// Where the handle lies on the screen of a canvas that is seen so.
glm::dvec2 light_handle_px(const LightDial& dial, const screen::ViewTransform& view,
                           const LightDirection& light);

/// The light whose handle lies there, or on the rim towards there. In the very middle the azimuth is
/// that of `before`.
LightDirection light_at(const LightDial& dial, const screen::ViewTransform& view,
                        const glm::dvec2& handle_px, const LightDirection& before);

}  // namespace pastoso::interactions

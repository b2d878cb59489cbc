#include "interactions/light_handle.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace pastoso::interactions {
namespace {

constexpr double kFull_deg = 90.0 - kLowestLight_deg;

/// Nearer to the middle there is no direction.
constexpr double kMiddle = 1e-3;

}  // namespace

glm::dvec2 light_handle_px(const LightDial& dial, const screen::ViewTransform& view,
                           const LightDirection& light) {
    const double azimuth = core::radians(light.azimuth_deg);
    const double share = std::min((90.0 - light.elevation_deg) / kFull_deg, 1.0);
    return dial.centre_px +
           dial.radius_px * share * (view.axes() * glm::dvec2(std::cos(azimuth), -std::sin(azimuth)));
}

LightDirection light_at(const LightDial& dial, const screen::ViewTransform& view,
                        const glm::dvec2& handle_px, const LightDirection& before) {
    const glm::dvec2 way = glm::transpose(view.axes()) * (handle_px - dial.centre_px) / dial.radius_px;
    const double share = std::min(glm::length(way), 1.0);
    const double elevation_deg = 90.0 - kFull_deg * share;
    if (share < kMiddle) return {before.azimuth_deg, elevation_deg};
    const double azimuth_deg = core::degrees(std::atan2(-way.y, way.x));
    return {azimuth_deg < 0.0 ? azimuth_deg + 360.0 : azimuth_deg, elevation_deg};
}

}  // namespace pastoso::interactions

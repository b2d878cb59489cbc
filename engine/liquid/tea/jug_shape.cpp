#include "liquid/tea/jug_shape.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace pastoso::liquid {
namespace {

/// Radius, and way along the axis from the mouth.
constexpr glm::vec2 kOutline_m[] = {{kJugMilkRadius_m, kJugMilkDepth_m},
                                    {0.0082F, 0.0F},
                                    {0.0096F, 0.0005F},
                                    {0.0092F, 0.003F},
                                    {0.0088F, 0.011F},
                                    {0.0113F, 0.0195F},
                                    {0.0155F, 0.027F},
                                    {0.0200F, 0.034F},
                                    {0.0233F, 0.041F},
                                    {0.0248F, 0.048F},
                                    {0.0252F, 0.056F},
                                    {0.0250F, 0.075F},
                                    {0.0238F, 0.080F},
                                    {0.0210F, 0.0832F},
                                    {0.0F, 0.0845F}};
constexpr std::size_t kPoints = std::size(kOutline_m);
/// How high its bottom is over its mouth: in the left half of the glass, and at the right wall.
constexpr float kTilt_deg = 48.0F, kSteepest_deg = 85.0F;

/// At the ends along a piece, elsewhere along the way from the point before to the one behind.
std::array<TurnedPoint, kPoints> profile() {
    std::array<TurnedPoint, kPoints> points;
    for (std::size_t n = 0; n < kPoints; ++n) {
        const glm::vec2 along =
            glm::normalize(kOutline_m[n + 1 < kPoints ? n + 1 : n] - kOutline_m[n > 0 ? n - 1 : n]);
        points[n] = {kOutline_m[n].x, kOutline_m[n].y, {along.y, -along.x}};
    }
    return points;
}

}  // namespace

JugPlace jug_place(const MilkStream& stream, const Cup& cup) {
    const float to_the_right = (stream.at_m.x - cup.axis_m.x) / cup.inner_radius_m(cup.level_m);
    const float tilt =
        glm::radians(glm::mix(kTilt_deg, kSteepest_deg, glm::smoothstep(0.0F, 0.9F, to_the_right)));
    const glm::vec3 axis(std::cos(tilt), 0.0F, std::sin(tilt));
    // The stream comes over the lower edge of the mouth.
    const glm::vec3 above(0.0F, 0.0F, 0.7F * stream.lip_radius_m);
    return {glm::vec3(stream.at_m, stream.lip_m) + above, axis};
}

std::span<const TurnedPoint> jug_profile() {
    static const std::array<TurnedPoint, kPoints> points = profile();
    return points;
}

}  // namespace pastoso::liquid

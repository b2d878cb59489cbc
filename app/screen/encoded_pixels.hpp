// Colours as the sixteen bits of a window's picture.
#pragma once

#include <QRgba64>
#include <glm/vec3.hpp>

namespace pastoso::screen {

inline constexpr double kMost16 = 65535.0;

/// Of values that are encoded already; those beyond 0 to 1 are cut.
QRgba64 encoded(const glm::dvec3& colour);

/// Of linear light, three values in [0, 1]: as pigment::encode_srgb16() does it, to a level.
QRgba64 encoded_light(float red, float green, float blue);

}  // namespace pastoso::screen

// Pictures of the engine as Qt shows them.
#pragma once

#include "pigment/image.hpp"

#include <cstdint>
#include <vector>

#include <QImage>

namespace pastoso::appearance {

/// Looks at the picture's own bytes, which outlive it: a copy() of it does not need them.
QImage view_of(const pigment::Image8& picture);

/// The same of red, green, blue and opacity in rows without gaps.
QImage view_of_rgba(const std::vector<std::uint8_t>& rgba, int width, int height);

}  // namespace pastoso::appearance

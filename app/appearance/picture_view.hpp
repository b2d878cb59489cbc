// Pictures of the engine as Qt shows them, and the other way round.
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

/// The same pixels.
pigment::Picture picture_of(const QImage& image);

}  // namespace pastoso::appearance

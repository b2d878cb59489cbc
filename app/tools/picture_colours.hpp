// Colours out of pictures: the few that one is made of, and the one that it has at a place.
#pragma once

#include "pigment/hex_colour.hpp"
#include "pigment/image.hpp"

#include <optional>
#include <vector>

namespace pastoso::tools {

/// At most `count` (1 or more) colours, dark to light, such that the squared distances in OKLab of the
/// picture's pixels to the nearest of them are small: k-means (Lloyd 1982), begun with colours drawn as
/// by Arthur and Vassilvitskii (k-means++, 2007) from noise that is the same each time. Pixels count by
/// their alpha. Fewer where the picture has fewer; none where nothing of it is seen. The same picture
/// gives the same colours.
std::vector<pigment::Srgb8> picture_colours(const pigment::Picture& picture, int count);

/// The mean, as light, of the pixels whose middles lie within `half_px` of (x_px, y_px) along both axes,
/// by their alpha; of the pixel there where no middle does. None beside the picture, or where nothing of
/// it is seen.
std::optional<pigment::Srgb8> mean_colour(const pigment::Picture& picture, double x_px, double y_px,
                                          double half_px);

/// The grey of the same luminance.
pigment::Srgb8 grey_of(const pigment::Srgb8& colour);

}  // namespace pastoso::tools

// The few colours that a picture is made of.
#pragma once

#include "pigment/hex_colour.hpp"
#include "pigment/image.hpp"

#include <vector>

namespace pastoso::tools {

/// At most `count` (1 or more) colours, dark to light, such that the squared distances in OKLab of the
/// picture's pixels to the nearest of them are small: k-means (Lloyd 1982), begun with colours drawn as
/// by Arthur and Vassilvitskii (k-means++, 2007) from noise that is the same each time. Pixels count by
/// their alpha. Fewer where the picture has fewer; none where nothing of it is seen. The same picture
/// gives the same colours.
std::vector<pigment::Srgb8> picture_colours(const pigment::Picture& picture, int count);

}  // namespace pastoso::tools

// Pictures that a camera held otherwise.
#pragma once

#include "pigment/image.hpp"

namespace pastoso::files {

/// A picture turned and mirrored so that it stands upright. `orientation` is that of EXIF 2.3: what the
/// first row and the first column of the picture are to be, 1 top and left, 2 top and right, 3 bottom
/// and right, 4 bottom and left, 5 left and top, 6 right and top, 7 right and bottom, 8 left and bottom.
/// Any other number counts as 1.
pigment::Picture upright(pigment::Picture picture, int orientation);

}  // namespace pastoso::files

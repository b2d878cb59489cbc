// What EXIF says of how a camera was held.
#pragma once

#include <string_view>

namespace pastoso::files {

/// The orientation in an EXIF block (a TIFF file without pixels; EXIF 2.3, tag 274 of its first
/// directory), 1 to 8; 1 where it says none or is damaged.
int exif_orientation(std::string_view exif);

}  // namespace pastoso::files

// How pictures are to look and how finely they are kept, as users name it.
#pragma once

#include "files/picture_file.hpp"
#include "pigment/viewing.hpp"

#include <string>

namespace pastoso::recordings {

struct PictureOptions {
    std::string light = "D65";     ///< pigment::find_illuminant()
    std::string profile = "srgb";  ///< picture_colours()
    int depth_bits = 8;
    int quality = 95;  ///< of JPEG and WebP
};

/// What they ask for.
struct PictureStyle {
    pigment::Viewing viewing;
    files::PictureEncoding encoding;
};

/// Throws InputError when there is no such light or profile.
PictureStyle picture_style(const PictureOptions& options);

}  // namespace pastoso::recordings

// Path-traced pictures as files.
#pragma once

#include "pigment/image.hpp"
#include "trace/picture.hpp"

#include <filesystem>

namespace pastoso::liquid_files {

/// What a screen shall show of a traced picture (trace::toned), in linear light.
pigment::LinearImage shown_image(const trace::Picture& radiance);

/// Throws InputError like check_picture_path(): to be asked before the work.
void check_traced_path(const std::filesystem::path& path);

/// Writes the radiance aside: EXR as it is, every other format as a screen shall show it, in
/// sRGB with 8 bits. Throws InputError when the name ends in no format for pictures, and when the
/// file cannot be written.
void write_traced_picture(const std::filesystem::path& path, const trace::Picture& radiance);

}  // namespace pastoso::liquid_files

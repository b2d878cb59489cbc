// What an OpenEXR file says of itself before its pixels.
#pragma once

#include "core/regular_file.hpp"

#include <string>

namespace pastoso::files {

/// Throws InputError when an OpenEXR file has an attribute that would reach beyond its end, or tells of
/// more pixels than are read (picture_rows.hpp): libraries make room for it as it is told, gigabytes for
/// a hundred bytes. `name` stands for the picture as picture_error() has it.
void check_exr_header(const core::RegularFile& file, const std::string& name);

}  // namespace pastoso::files

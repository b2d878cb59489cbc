// What an OpenEXR file says of itself before its pixels.
#pragma once

#include <filesystem>

namespace pastoso::files {

/// Throws InputError when `path` is an OpenEXR file with an attribute that would reach beyond its end:
/// libraries make room for it as it is told, gigabytes for a hundred bytes. Other files pass.
void check_exr_header(const std::filesystem::path& path);

}  // namespace pastoso::files

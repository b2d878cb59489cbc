// The chunks that a PNG file consists of (W3C Portable Network Graphics, third edition).
#pragma once

#include <string>
#include <string_view>

namespace pastoso::io {

/// Whether the text begins as PNG files do.
bool is_png(std::string_view file);

/// Whether a chunk of this type (four letters) stands before the picture's data.
bool has_png_chunk(std::string_view file, std::string_view type);

/// The file with a chunk of this type and data after its first, the header. `file` is a whole PNG file.
std::string with_png_chunk(std::string_view file, std::string_view type, std::string_view data);

}  // namespace pastoso::io

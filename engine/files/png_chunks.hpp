// The chunks that a PNG file consists of (W3C Portable Network Graphics, third edition).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pastoso::files {

/// Whether the text begins as PNG files do.
bool is_png(std::string_view file);

/// Whether a chunk of this type (four letters) stands before the picture's data.
bool has_png_chunk(std::string_view file, std::string_view type);

/// How many bytes a PNG file begins with: its signature and its header chunk.
inline constexpr std::size_t kPngHeadBytes = 33;

/// The file with a chunk of this type and data after its first, the header. `file` is a PNG file, or the
/// beginning of one.
std::string with_png_chunk(std::string_view file, std::string_view type, std::string_view data);

}  // namespace pastoso::files

// The chunks that a WebP file consists of (RFC 9649).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pastoso::files {

/// How many bytes a WebP file begins with before its first chunk.
inline constexpr std::size_t kWebpHeadBytes = 12;

/// What takes the place of those bytes in a plain WebP file of this size, so that it holds an ICC
/// profile: an extended header and the profile, before the picture.
std::string webp_head_with_profile(std::size_t file_bytes, int width, int height,
                                   std::string_view profile);

}  // namespace pastoso::files

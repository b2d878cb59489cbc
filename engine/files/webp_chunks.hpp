// The chunks that a WebP file consists of (RFC 9649).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pastoso::files {

/// How many bytes a WebP file begins with before its first chunk.
inline constexpr std::size_t kWebpHeadBytes = 12;

/// What takes the place of those bytes of a plain WebP file, so that it holds an ICC profile: an extended
/// header and the profile, before the picture.
std::string webp_head_with_profile(std::string_view head, int width, int height, std::string_view profile);

}  // namespace pastoso::files

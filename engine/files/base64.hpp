// Bytes as text (RFC 4648, section 4).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pastoso::files {

std::string base64(std::string_view bytes);

/// Nothing for a text that base64() does not write.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace pastoso::files

#include "files/webp_chunks.hpp"

#include <cstdint>

namespace pastoso::files {
namespace {

constexpr char kHoldsProfile = 0x20;

std::string little_endian(std::size_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i)
        text += static_cast<char>(value >> (8 * i) & 0xFFU);
    return text;
}

/// Chunks have even lengths.
std::string chunk(std::string_view type, std::string_view data) {
    std::string text = std::string(type) + little_endian(data.size(), 4) + std::string(data);
    if (data.size() % 2 != 0) text += '\0';
    return text;
}

}  // namespace

std::string webp_head_with_profile(std::size_t file_bytes, int width, int height,
                                   std::string_view profile) {
    const std::string size = little_endian(static_cast<std::size_t>(width - 1), 3) +
                             little_endian(static_cast<std::size_t>(height - 1), 3);
    const std::string added =
        chunk("VP8X", std::string{kHoldsProfile, 0, 0, 0} + size) + chunk("ICCP", profile);
    return "RIFF" + little_endian(file_bytes - 8 + added.size(), 4) + "WEBP" + added;
}

}  // namespace pastoso::files

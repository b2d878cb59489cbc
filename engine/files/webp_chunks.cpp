#include "files/webp_chunks.hpp"

#include "files/byte_order.hpp"

#include <cstdint>

namespace pastoso::files {
namespace {

constexpr char kHoldsProfile = 0x20;

/// Chunks have even lengths.
std::string chunk(std::string_view type, std::string_view data) {
    std::string text =
        std::string(type) + little_endian(static_cast<std::uint32_t>(data.size())) + std::string(data);
    if (data.size() % 2 != 0) text += '\0';
    return text;
}

}  // namespace

std::string webp_head_with_profile(std::string_view head, int width, int height,
                                   std::string_view profile) {
    const std::string size = little_endian(static_cast<std::uint32_t>(width - 1), 3) +
                             little_endian(static_cast<std::uint32_t>(height - 1), 3);
    const std::string added =
        chunk("VP8X", std::string{kHoldsProfile, 0, 0, 0} + size) + chunk("ICCP", profile);
    return "RIFF" + little_endian(little_endian_at(head, 4) + static_cast<std::uint32_t>(added.size())) +
           "WEBP" + added;
}

}  // namespace pastoso::files

#include "core/printable.hpp"

#include <cstddef>
#include <cstdint>

namespace pastoso::core {
namespace {

bool goes_on(std::string_view text, std::size_t place) {
    return place < text.size() && (static_cast<unsigned char>(text[place]) & 0xC0U) == 0x80U;
}

/// How many bytes the character at a place has (RFC 3629); 0 where there is none, or one of the controls
/// of ISO 6429.
std::size_t shown_bytes(std::string_view text, std::size_t place) {
    const auto first = static_cast<unsigned char>(text[place]);
    if (first < 0x80U) return (first >= 0x20U && first != 0x7FU) || first == '\n' || first == '\t' ? 1 : 0;
    const std::size_t bytes = first >= 0xF0U ? 4 : first >= 0xE0U ? 3 : 2;
    if (first < 0xC2U || first > 0xF4U) return 0;
    for (std::size_t i = 1; i < bytes; ++i)
        if (!goes_on(text, place + i)) return 0;
    const auto second = static_cast<unsigned char>(text[place + 1]);
    const bool is_control = first == 0xC2U && second < 0xA0U;
    const bool is_other = (first == 0xE0U && second < 0xA0U) || (first == 0xEDU && second > 0x9FU) ||
                          (first == 0xF0U && second < 0x90U) || (first == 0xF4U && second > 0x8FU);
    return is_control || is_other ? 0 : bytes;
}

}  // namespace

std::string printable(std::string_view text) {
    static constexpr char kDigits[] = "0123456789abcdef";
    std::string shown;
    for (std::size_t place = 0; place < text.size();) {
        const std::size_t bytes = shown_bytes(text, place);
        if (bytes > 0) {
            shown += text.substr(place, bytes);
            place += bytes;
            continue;
        }
        const auto byte = static_cast<unsigned char>(text[place++]);
        shown += {'\\', 'x', kDigits[byte >> 4U], kDigits[byte & 0xFU]};
    }
    return shown;
}

}  // namespace pastoso::core

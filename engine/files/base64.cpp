#include "files/base64.hpp"

#include <array>
#include <cstdint>

namespace pastoso::files {
namespace {

constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint32_t kNone = 64;

std::uint32_t value_of(char digit) {
    static const auto values = [] {
        std::array<std::uint8_t, 256> table{};
        table.fill(kNone);
        for (std::size_t i = 0; i < kDigits.size(); ++i)
            table[static_cast<unsigned char>(kDigits[i])] = static_cast<std::uint8_t>(i);
        return table;
    }();
    return values[static_cast<unsigned char>(digit)];
}

}  // namespace

std::string base64(std::string_view bytes) {
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= count ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
    }
    return text;
}

std::optional<std::string> from_base64(std::string_view text) {
    if (text.size() % 4 != 0) return std::nullopt;
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3);
    for (std::size_t i = 0; i < text.size(); i += 4) {
        const bool last = i + 4 == text.size();
        const std::size_t fill = !last || text[i + 3] != '=' ? 0 : text[i + 2] != '=' ? 1 : 2;
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const std::uint32_t value = k < 4 - fill ? value_of(text[i + k]) : 0U;
            if (value == kNone) return std::nullopt;
            group = group << 6 | value;
        }
        for (std::size_t k = 0; k < 3 - fill; ++k)
            bytes += static_cast<char>(group >> (16 - 8 * k) & 255U);
        const std::uint32_t rest = fill == 0 ? 0U : group & (fill == 1 ? 255U : 65535U);
        if (rest != 0) return std::nullopt;
    }
    return bytes;
}

}  // namespace pastoso::files

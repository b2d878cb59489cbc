#include "pigment/hex_colour.hpp"

#include <charconv>
#include <cmath>

namespace pastoso::pigment {

std::optional<Srgb8> parse_hex_colour(std::string_view text) {
    constexpr std::size_t kLength = 7;
    if (text.size() != kLength || text.front() != '#') return std::nullopt;
    Srgb8 colour{};
    for (std::size_t i = 0; i < colour.size(); ++i) {
        const char* first = text.data() + 1 + 2 * i;
        const auto [end, status] = std::from_chars(first, first + 2, colour[i], 16);
        if (status != std::errc{} || end != first + 2) return std::nullopt;
    }
    return colour;
}

std::string hex_colour(const Srgb8& colour) {
    static constexpr char kDigits[] = "0123456789abcdef";
    std::string text = "#";
    for (const std::uint8_t channel : colour) {
        text += kDigits[channel / 16];
        text += kDigits[channel % 16];
    }
    return text;
}

Srgb8 encoded(const LinearRgb& colour) {
    const LinearRgb shown = into_gamut(colour);
    Srgb8 result{};
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = static_cast<std::uint8_t>(std::lround(255.0 * encode_srgb(shown[i])));
    return result;
}

LinearRgb decoded(const Srgb8& colour) {
    LinearRgb result{};
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = static_cast<float>(decode_srgb(colour[i] / 255.0));
    return result;
}

}  // namespace pastoso::pigment

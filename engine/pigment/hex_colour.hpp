// Colours as they are written: "#c03020", red, green and blue of sRGB in hexadecimal.
#pragma once

#include "pigment/colour.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pastoso::pigment {

/// Red, green and blue of encoded sRGB.
using Srgb8 = std::array<std::uint8_t, 3>;

/// Nothing for a text that is not # and six hexadecimal digits, capital or small.
std::optional<Srgb8> parse_hex_colour(std::string_view text);

/// "#c03020", small letters.
std::string hex_colour(const Srgb8& colour);

/// A colour brought into the gamut and rounded to what a screen shows.
Srgb8 encoded(const LinearRgb& colour);

LinearRgb decoded(const Srgb8& colour);

}  // namespace pastoso::pigment

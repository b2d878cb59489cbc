#include "pigment/paint_name.hpp"

#include "core/error.hpp"
#include "pigment/hex_colour.hpp"
#include "pigment/palette.hpp"
#include "pigment/rgb_paint.hpp"

namespace pastoso::pigment {
namespace {

Srgb8 colour_named(std::string_view name) {
    if (const auto colour = parse_hex_colour(name)) return *colour;
    throw core::InputError(
        "\"%1\" is not a colour; a colour is # and six hexadecimal digits, for example #c03020.", name);
}

}  // namespace

bool names_a_colour(std::string_view name) {
    return name.starts_with('#');
}

Coefficients named_paint(std::string_view name) {
    if (!names_a_colour(name)) return find_pigment(name).coefficients;
    return rgb_paint(decoded(colour_named(name))).coefficients;
}

void check_paint_name(std::string_view name) {
    if (names_a_colour(name))
        colour_named(name);
    else
        find_pigment(name);
}

std::string painters_name(std::string_view name) {
    return names_a_colour(name) ? std::string(name) : find_pigment(name).name;
}

}  // namespace pastoso::pigment

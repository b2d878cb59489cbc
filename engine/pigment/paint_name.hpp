// The paints of a recipe by name: pigments, and colours of a screen.
#pragma once

#include "pigment/bands.hpp"

#include <string>
#include <string_view>

namespace pastoso::pigment {

/// The full-strength paint of that name: a pigment by its Colour Index name (find_pigment()), or a
/// colour of sRGB as "#c03020" (rgb_paint()). Throws InputError when it is neither.
Coefficients named_paint(std::string_view name);

/// Whether the name stands for a colour, well written or not: it begins with #.
bool names_a_colour(std::string_view name);

/// Throws the error of named_paint() without making the paint.
void check_paint_name(std::string_view name);

/// What painters call a paint: the pigment's name, or the colour itself.
std::string painters_name(std::string_view name);

}  // namespace pastoso::pigment

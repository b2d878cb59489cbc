// Words painted with a brush, in single strokes.
#pragma once

#include "paths.hpp"

#include <string_view>

namespace pastoso::examples {

/// A rigger that goes where the hand goes and fills the weave.
brush::Preset lettering_pen(double width_mm);

/// Writes capitals A-Z, digits and spaces with the brush in hand from the upper left corner of the first
/// letter on; other characters are left out as spaces. Letters are `height_mm` high.
void write(Painter& painter, std::string_view words, Point corner, double height_mm);

}  // namespace pastoso::examples

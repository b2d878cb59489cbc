// The colour of the paint at a place of the canvas.
#pragma once

#include "document/painting.hpp"
#include "pigment/hex_colour.hpp"

#include <optional>

namespace pastoso::tools {

/// What is seen there under even daylight, as a colour of a screen whose white is titanium white: the
/// mean of 3 x 3 cells. Nothing outside the canvas.
std::optional<pigment::Srgb8> colour_at(const document::Snapshot& snapshot, double x_mm, double y_mm);

}  // namespace pastoso::tools

// What a paint looks like on a paint chart.
#pragma once

#include "pigment/bands.hpp"
#include "pigment/hex_colour.hpp"

namespace pastoso::tools {

struct Swatch {
    pigment::Srgb8 masstone{};  ///< an opaque layer of the paint as it comes from the tube
    pigment::Srgb8 tint{};      ///< the same mixed with titanium white, one part to four
};

/// Diffuse colour under D65, without the highlight of the surface.
Swatch swatch(const pigment::Coefficients& paint);

}  // namespace pastoso::tools

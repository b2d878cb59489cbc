// What a paint looks like on a paint chart.
#pragma once

#include "pigment/palette.hpp"

#include <array>
#include <cstdint>

namespace pastoso::tools {

using Srgb8 = std::array<std::uint8_t, 3>;

struct Swatch {
    Srgb8 masstone{};  ///< an opaque layer of the paint as it comes from the tube
    Srgb8 tint{};      ///< the same mixed with titanium white, one part to four
};

/// Diffuse colour under D65, without the highlight of the surface.
Swatch swatch(const pigment::Pigment& pigment);

}  // namespace pastoso::tools

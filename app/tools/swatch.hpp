// What a paint looks like on a paint chart.
#pragma once

#include "document/events.hpp"
#include "film/cell/paint_cell.hpp"
#include "pigment/bands.hpp"
#include "pigment/hex_colour.hpp"

namespace pastoso::tools {

struct Swatch {
    pigment::Srgb8 masstone{};  ///< an opaque layer of the paint as it comes from the tube
    pigment::Srgb8 tint{};      ///< the same mixed with titanium white, one part to four
};

/// Diffuse colour under D65, without the highlight of the surface.
Swatch swatch(const pigment::Coefficients& paint);

/// What stands for paint that has no colour of its own.
inline constexpr pigment::Srgb8 kClearMedium = {232, 230, 224};

/// The masstone of paint as a brush holds it, or of a mixture.
pigment::Srgb8 paint_colour(const film::PaintCoefficients& paint);
pigment::Srgb8 paint_colour(const document::PaintRecipe& paint);

/// The same beside colours of a screen, whose white stands for titanium white: the colour that
/// colour_paint() makes this paint's colour of.
pigment::Srgb8 screen_colour(const document::PaintRecipe& paint);

}  // namespace pastoso::tools

// What a paint looks like on a chart: thick, thin, and mixed with white, under D65 and without the
// highlight of its surface.
#pragma once

#include "pigment/bands.hpp"
#include "pigment/colour.hpp"

#include <array>

namespace pastoso::pigment {

/// What leaves an opaque layer of a paint, per band (after the surface).
Bands opaque_bands(const Coefficients& paint);

/// Reflectance inside the binder of an opaque layer of titanium white: a white ground for films.
Bands titanium_ground();

/// The colour of an opaque layer; may lie outside sRGB.
LinearRgb masstone(const Coefficients& paint);

inline constexpr double kUndertoneFilm_mm = 0.025;

/// The colour of a film of that thickness over opaque titanium white.
LinearRgb undertone(const Coefficients& paint, double film_mm = kUndertoneFilm_mm);

inline constexpr double kTintWhiteParts = 10.0;

/// The masstone of one part of the paint in that many parts of titanium white by volume.
LinearRgb tint(const Coefficients& paint, double white_parts = kTintWhiteParts);

inline constexpr double kHidingFilm_mm = 0.1;

/// Opacity: the luminance of a film over a black ground as a share of that over titanium white
/// (contrast ratio, ISO 2814). 0 clear, 1 hides everything.
double contrast_ratio(const Coefficients& paint, double film_mm = kHidingFilm_mm);

inline constexpr double kPaleDifference = 10.0;

/// Tinting strength: the parts of titanium white, up to 10000, in which one part of the paint makes a
/// tint that differs from the white by kPaleDifference in CIEDE2000. 0 for whites, which never do.
double tinting_strength(const Coefficients& paint);

/// Reflectance of the whitest paint. White on a screen stands for it, so that every colour of a screen
/// has a paint, and a paint's colour is given to the screen in proportion to it.
inline constexpr double kPaintWhite = 0.955;

LinearRgb paint_colour(const LinearRgb& on_screen);  ///< times kPaintWhite
LinearRgb screen_colour(const LinearRgb& of_paint);  ///< divided by kPaintWhite

}  // namespace pastoso::pigment

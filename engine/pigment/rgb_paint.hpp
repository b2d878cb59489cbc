// A paint for any colour of a screen: absorption and scattering that give this colour when opaque, and
// that mix like a real pigment's.
#pragma once

#include "pigment/bands.hpp"
#include "pigment/colour.hpp"

namespace pastoso::pigment {

/// No stronger than the strongest yellows and reds of the palette.
inline constexpr double kStrongestAbsorption_per_mm = 300.0;

/// Coefficients per mm of a paint of these reflectances: the surface undone,
///
///     R = Rd / ((1 - k1)(1 - k2) + k2 Rd),   K / S = (1 - R)^2 / (2 R),
///     S = 60 opacity (0.2 + 0.8 R),
///
/// dark paints scattering less, as most real ones do. S is smaller where K would exceed
/// kStrongestAbsorption_per_mm. `opacity` is 0.05 (for glazes) to 3 (hides like titanium white).
Coefficients paint_of_bands(const Bands& reflectance, double opacity = 1.0);

struct RgbPaint {
    Coefficients coefficients{};
    double difference = 0.0;  ///< CIEDE2000 between its masstone and the colour wanted
};

/// The paint of a colour on a screen (linear sRGB, 0 to 1), whose white stands for titanium white
/// (kPaintWhite).
RgbPaint rgb_paint(const LinearRgb& on_screen, double opacity = 1.0);

}  // namespace pastoso::pigment

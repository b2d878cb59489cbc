// Reflectances for the colours of pictures: those of smooth_bands() where a table has them, and means of
// these between.
#pragma once

#include "pigment/bands.hpp"
#include "pigment/colour.hpp"

namespace pastoso::pigment {

/// Levels of red, green and blue each that the table has: decode_srgb(k / 16).
inline constexpr int kRgbBandsLevels = 17;

/// Reflectances (after the surface) of the paint for a colour on a screen (linear sRGB, clamped to 0 to
/// 1), whose white stands for titanium white as in rgb_paint(). Trilinear in linear light between the
/// eight colours of the table around it. A colour is a linear function of its reflectances, so it is met
/// as well as the table's colours are; only the shape of the spectrum is a mean.
///
/// The first call makes the table, about 0.1 s of work. The same colour gives the same
/// bits on every machine. Safe on any thread.
Bands rgb_bands(const LinearRgb& on_screen);

}  // namespace pastoso::pigment

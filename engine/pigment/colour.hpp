// From reflectances in the bands to colours on a screen: linear light under D65, gamut, transfer curve.
#pragma once

#include "pigment/bands.hpp"
#include "pigment/working_space.hpp"

#include <array>

namespace pastoso::pigment {

/// Red, green and blue of linear light in a working space, sRGB unless stated; 0 to 1 inside the gamut.
using LinearRgb = std::array<float, 3>;

/// One row of weights each for red, green and blue, whose sum is 1: a reflectance of 1 in all bands is
/// the white.
using BandsToRgb = std::array<Bands, 3>;

/// Band reflectances seen under D65 by the CIE 1931 observer, in linear sRGB ("band_to_linear_sRGB_D65"
/// of resources/pigments/bands_6.json): what band_fit.hpp finds for D65, rounded so that the rows still
/// add up to 1.
inline constexpr BandsToRgb kBandsToLinearSrgb = {{
    {0.0490941405F, -0.215472072F, -0.263680398F, 0.199617058F, 0.709050357F, 0.521390915F},
    {-0.0810760111F, 0.20092614F, 0.473484725F, 0.386907101F, 0.0665526986F, -0.0467946529F},
    {0.98027426F, 0.151456311F, -0.0549508594F, -0.046314463F, -0.0299216677F, -0.000543581322F},
}};

/// The colour of a surface of these (air-side) reflectances; may lie outside the gamut.
LinearRgb seen_colour(const Bands& reflectance, const BandsToRgb& to_rgb);

/// The same under D65 in sRGB.
LinearRgb linear_srgb(const Bands& reflectance);

/// Brings a colour into [0, 1]: the mean of clipping every channel and of moving towards the grey of the
/// same luminance until it fits. Of the methods tried it keeps hue nearly as well as the second at the
/// smaller colour difference of the first. Colours inside the gamut stay as they are. `space` is the one
/// that the channels belong to.
LinearRgb into_gamut(const LinearRgb& colour, WorkingSpace space = WorkingSpace::Srgb);

/// The transfer curve of sRGB (IEC 61966-2-1) and of Display P3, and its inverse, for values in [0, 1].
/// Decoding gives the same bits on every machine: recordings name paints by encoded colours.
double encode_srgb(double linear);
double decode_srgb(double encoded);

}  // namespace pastoso::pigment

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
/// of resources/pigments/bands_6.json).
inline constexpr BandsToRgb kBandsToLinearSrgb = {{
    {0.0475828499F, -0.210500739F, -0.271995176F, 0.199917813F, 0.716593343F, 0.51840191F},
    {-0.0786136835F, 0.188500817F, 0.489884603F, 0.376586823F, 0.0692994162F, -0.0456579747F},
    {0.987770637F, 0.145225176F, -0.0587831643F, -0.040976075F, -0.0368353254F, 0.00359875237F},
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

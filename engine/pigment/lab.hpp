// Colours as they are seen: CIE 1976 L*a*b* under D65, and the differences that are noticed.
#pragma once

#include "pigment/colour.hpp"

#include <array>

namespace pastoso::pigment {

/// CIE 1931 tristimulus values; Y of a perfect white is 1.
using Xyz = std::array<double, 3>;

struct Lab {
    double lightness = 0, a = 0, b = 0;
    double chroma() const;
    double hue_deg() const;  ///< 0 red, 90 yellow, 180 green, 270 blue; 0 <= h < 360
};

/// The cube root that Lab is made of, a line for dark t <= (6/29)^3, and its slope. From operations that
/// give the same bits on every machine.
double lab_curve(double t);
double lab_curve_slope(double t);

/// Lab of a colour seen beside `white`.
Lab lab(const Xyz& colour, const Xyz& white);

/// XYZ of linear sRGB, each divided by that of the white: a row each for X, Y and Z (IEC 61966-2-1, not
/// rounded to four digits), whose sum is 1.
extern const std::array<Xyz, 3> kSrgbToWhiteRelativeXyz;

/// Y of a colour in linear sRGB, that of white being 1.
double relative_luminance(const LinearRgb& colour);

/// Lab of a colour in linear sRGB, which may lie outside the gamut.
Lab lab(const LinearRgb& colour);

/// The colour difference CIEDE2000 (Sharma, Wu, Dalal: Color Research and Application 30, 2005), all
/// weights 1. About 1 is seen side by side, 2 to 3 at a second look.
double ciede2000(const Lab& first, const Lab& second);

/// Weights of small differences in lightness, chroma and hue from `colour`, as in CIEDE2000 without its
/// turn of the blues: dE^2 = (wl dL)^2 + (wc dC)^2 + (wh dH)^2.
struct DifferenceWeights {
    double lightness = 1, chroma = 1, hue = 1;
};
DifferenceWeights difference_weights(const Lab& colour);

}  // namespace pastoso::pigment

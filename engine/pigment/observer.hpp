// What the eye sees of a spectrum: the CIE 1931 standard observer.
#pragma once

#include "pigment/matrix3.hpp"
#include "pigment/spectrum.hpp"

namespace pastoso::pigment {

/// The colour-matching functions of the CIE 1931 2-degree observer (CIE 015), every 10 nm from 380 to
/// 730 nm.
inline constexpr Spectrum kColourMatchingX = {
    .001368, .004243, .014310, .043510,  .134380,  .283900,  .348280, .336200, .290800,
    .195360, .095640, .032010, .004900,  .009300,  .063270,  .165500, .290400, .433450,
    .594500, .762100, .916300, 1.026300, 1.062200, 1.002600, .854450, .642400, .447900,
    .283500, .164900, .087400, .046770,  .022700,  .011359,  .005790, .002899, .001440};
inline constexpr Spectrum kColourMatchingY = {
    .000039, .000120, .000396, .001210, .004000, .011600, .023000, .038000, .060000,
    .090980, .139020, .208020, .323000, .503000, .710000, .862000, .954000, .994950,
    .995000, .952000, .870000, .757000, .631000, .503000, .381000, .265000, .175000,
    .107000, .061000, .032000, .017000, .008210, .004102, .002091, .001047, .000520};
inline constexpr Spectrum kColourMatchingZ = {
    .006450,  .020050, .067850, .207400, .645600, 1.385600, 1.747060, 1.772110, 1.669200,
    1.287640, .812950, .465180, .272000, .158200, .078250,  .042160,  .020300,  .008750,
    .003900,  .002100, .001650, .001100, .000800, .000340,  .000190,  .000050,  .000020,
    0,        0,       0,       0,       0,       0,        0,        0,        0};

/// CIE XYZ of a surface of these reflectances under a light of this spectral power (any unit, not all
/// 0): sums of power, reflectance and colour-matching functions over the 36 samples, scaled so that Y of
/// a reflectance of 1 is 1.
inline Vector3 tristimulus(const Spectrum& reflectance, const Spectrum& power) {
    Vector3 sum{};
    double white = 0.0;
    for (int i = 0; i < kSpectralSamples; ++i) {
        const double light = power[i] * reflectance[i];
        sum[0] += light * kColourMatchingX[i];
        sum[1] += light * kColourMatchingY[i];
        sum[2] += light * kColourMatchingZ[i];
        white += power[i] * kColourMatchingY[i];
    }
    for (double& value : sum)
        value /= white;
    return sum;
}

/// CIE XYZ of the perfect white under a light; Y is 1.
inline Vector3 white_under(const Spectrum& power) {
    Spectrum white{};
    white.fill(1.0);
    return tristimulus(white, power);
}

}  // namespace pastoso::pigment

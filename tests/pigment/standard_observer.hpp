// The CIE 1931 2-degree observer and the illuminant D65 (CIE 015), every 10 nm from 380 to 730 nm.
#pragma once

#include "pigment/lab.hpp"
#include "pigment/spectrum.hpp"

namespace pastoso::test {

inline constexpr pigment::Spectrum kObserverX = {
    .001368, .004243, .014310, .043510,  .134380,  .283900,  .348280, .336200, .290800,
    .195360, .095640, .032010, .004900,  .009300,  .063270,  .165500, .290400, .433450,
    .594500, .762100, .916300, 1.026300, 1.062200, 1.002600, .854450, .642400, .447900,
    .283500, .164900, .087400, .046770,  .022700,  .011359,  .005790, .002899, .001440};
inline constexpr pigment::Spectrum kObserverY = {
    .000039, .000120, .000396, .001210, .004000, .011600, .023000, .038000, .060000,
    .090980, .139020, .208020, .323000, .503000, .710000, .862000, .954000, .994950,
    .995000, .952000, .870000, .757000, .631000, .503000, .381000, .265000, .175000,
    .107000, .061000, .032000, .017000, .008210, .004102, .002091, .001047, .000520};
inline constexpr pigment::Spectrum kObserverZ = {
    .006450,  .020050, .067850, .207400, .645600, 1.385600, 1.747060, 1.772110, 1.669200,
    1.287640, .812950, .465180, .272000, .158200, .078250,  .042160,  .020300,  .008750,
    .003900,  .002100, .001650, .001100, .000800, .000340,  .000190,  .000050,  .000020,
    0,        0,       0,       0,       0,       0,        0,        0,        0};
inline constexpr pigment::Spectrum kDaylight65 = {
    49.9755, 54.6482, 82.7549, 91.4860, 93.4318, 86.6823, 104.865, 117.008, 117.812,
    114.861, 115.923, 108.811, 109.354, 107.802, 104.790, 107.689, 104.405, 104.046,
    100.000, 96.3342, 95.7880, 88.6856, 90.0062, 89.5991, 87.6987, 83.2886, 83.6992,
    80.0268, 80.2146, 82.2778, 78.2842, 69.7213, 71.6091, 74.3490, 61.6040, 69.8856};

/// Tristimulus values of a reflectance under D65; Y of a reflectance of 1 is 1.
inline pigment::Xyz tristimulus(const pigment::Spectrum& reflectance) {
    pigment::Xyz sum{};
    double white = 0.0;
    for (int i = 0; i < pigment::kSpectralSamples; ++i) {
        const double light = kDaylight65[i] * reflectance[i];
        sum[0] += light * kObserverX[i];
        sum[1] += light * kObserverY[i];
        sum[2] += light * kObserverZ[i];
        white += kDaylight65[i] * kObserverY[i];
    }
    for (double& value : sum)
        value /= white;
    return sum;
}

}  // namespace pastoso::test

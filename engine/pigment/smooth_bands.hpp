// A reflectance in the six bands for a colour.
#pragma once

#include "pigment/bands.hpp"
#include "pigment/colour.hpp"

namespace pastoso::pigment {

/// The reflectances that a fit may choose from, exclusive: below, a paint would have to absorb more than
/// 170 times what it scatters; the upper one lies just above the whitest pigment.
inline constexpr double kDarkestBand = 0.001;
inline constexpr double kLightestBand = 0.96;

/// The weight of the colour against the smoothness of the spectrum, per unit of CIE Lab.
inline constexpr double kColourWeight = 100.0;
inline constexpr int kMostIterations = 55;

struct SmoothBands {
    Bands reflectance{};
    double difference = 0.0;  ///< CIEDE2000 of its colour to the one wanted
    int iterations = 0;       ///< at most kMostIterations
    bool converged = false;  ///< false: the colour is right, but the spectrum could be a little smoother
};

/// The smoothest reflectance (after the surface) that has the colour `colour` (linear sRGB). With
///
///     R_k = lo + (hi - lo) (1/2 + z_k / (2 sqrt(1 + z_k^2)))
///
/// (the sigmoid of Jakob and Hanika: A Low-Dimensional Function Space for Efficient Spectral Upsampling,
/// Computer Graphics Forum 38, 2019, here one for every band) it minimises
///
///     sum_k (z_k+1 - z_k)^2 / (lambda_k+1 - lambda_k) + (kColourWeight dE)^2,   dE the distance in Lab,
///
/// by Levenberg and Marquardt's method, the weight of the colour growing in stages. The same colour
/// gives the same bits on every machine. A colour that no reflectance in these bounds has, such as
/// perfect black, is met as nearly as can be.
SmoothBands smooth_bands(const LinearRgb& colour);

}  // namespace pastoso::pigment

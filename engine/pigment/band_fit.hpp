// How a light makes the six bands look: the matrix from their reflectances to a colour.
#pragma once

#include "pigment/matrix3.hpp"
#include "pigment/spectrum.hpp"

namespace pastoso::pigment {

/// One row each for X, Y and Z.
using BandsToXyz = std::array<std::array<double, kBands>, 3>;

/// The matrix M that shows band reflectances as they look under a light of this spectral power to an eye
/// adapted to it: CIE XYZ after the Bradford transform from the light's white to that of D65. Its rows
/// add up to that white exactly. M minimises the sum of
///
///     (M r - t)' G (M r - t)
///
/// over 3000 fixed mixtures of the palette, half of them tints, where r are a mixture's reflectances in
/// the bands, t its colour from the full spectrum, and G the metric of CIEDE2000 at t, so that the sum
/// is one of squared visible differences; large ones are then weighted down (Huber 1964), since it is
/// the mean that is wanted small. The same bits on every machine; takes some milliseconds.
BandsToXyz fitted_bands_to_xyz(const Spectrum& power);

}  // namespace pastoso::pigment

// The colour of paint: absorption K and scattering S in six bands of the visible spectrum.
#pragma once

#include <array>

namespace pastoso::pigment {

inline constexpr int kBands = 6;

/// K in every band, then S in every band.
inline constexpr int kChannels = 2 * kBands;

/// Kubelka-Munk coefficients of a paint, per millimetre of thickness: K_0..K_5, S_0..S_5, all >= 0.
/// Mixing by volume is the weighted mean of these numbers.
using Coefficients = std::array<float, kChannels>;

/// No paint has a coefficient above this: a cell of the film could not hold a thick layer of it.
inline constexpr float kMostPerMm = 1090.0F;

/// One value per band, for example a reflectance.
using Bands = std::array<float, kBands>;

}  // namespace pastoso::pigment

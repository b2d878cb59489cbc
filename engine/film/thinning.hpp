// Paint that is thinned before it comes onto the brush: from paste to stain.
#pragma once

#include "film/medium.hpp"

namespace pastoso::film {

/// The least share of paint in a stain.
inline constexpr double kLeastPaintShare = 0.02;

/// `paint_share` parts by volume of a medium, kLeastPaintShare to 1, in 1 - paint_share of its thinner.
/// Numbers are the means by volume, but for:
///
///     ln nu = sum(share ln nu)          Arrhenius 1887, as paints mix on the canvas
///     tau_y = tau_paint share^3         the yield stress of a network of particles falls with the third to
///                                       fourth power of their volume (Buscall et al., J. Non-Newtonian
///                                       Fluid Mech. 24, 1987); the thinner has none
///     pigment_share = that of the medium times paint_share
///     typical thickness: the geometric mean; touch-dry: the mean of hours per millimetre
///
/// A medium that nothing thins stays as it is.
Medium thinned(const Medium& medium, double paint_share);

}  // namespace pastoso::film

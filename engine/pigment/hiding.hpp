// How well a film of paint hides what lies below it, in the four grades that are printed on tubes.
#pragma once

#include "pigment/bands.hpp"

namespace pastoso::pigment {

enum class Hiding { Transparent, SemiTransparent, SemiOpaque, Opaque };

/// Thick enough, every paint hides: charts of paint draw each out to a thin film, and there its grade is
/// seen. The share of a film's thickness that is left where it is drawn out.
inline constexpr double kDrawnOut = 0.125;

/// The grade of a film from its contrast ratio C = Yb / Yw (contrast_ratio(); ISO 2814) where it is
/// drawn out: Yb and Yw are the luminances, under D65, of kDrawnOut film_mm over black and over opaque
/// titanium white.
///
///     C < 0.15   transparent
///     C < 0.30   semi-transparent
///     C < 0.35   semi-opaque
///     otherwise  opaque
///
/// The bounds sort the bundled pigments, in the film of a flat bristle brush (0.22 mm) at full strength,
/// as painters know them. Two come out opaque that are known as transparent, dioxazine violet and
/// Prussian blue: they are measured so strong that no light comes back from below even there. `paint` is
/// what the light meets, per mm of film.
Hiding hiding_of(const Coefficients& paint, double film_mm);

}  // namespace pastoso::pigment

// Paint stirred into a layer of which only what it does to light is known.
#pragma once

#include "pigment/layer_optics.hpp"

namespace pastoso::pigment {

/// Optical thicknesses of a homogeneous layer, both >= 0.
struct OpticalThickness {
    double kh, sh;
};

/// Those of the homogeneous layer that reflects from above and lets through what this one does (Kubelka
/// 1948), with R = reflectance and T = transmittance:
///
///     a = (1 + R^2 - T^2) / (2 R),   b = sqrt(a^2 - 1),   S h = asinh(b R / T) / b,   K h = (a - 1) S h
///
/// Of a layer that hides what lies below, T no longer tells how thick it is: it counts as one that lets
/// through kLeastThrough, just hiding.
OpticalThickness optical_thickness(const LayerOptics<double>& layer);
inline constexpr double kLeastThrough = 1e-3;

/// The layer with a share of its volume exchanged for another paint, which would be of those optical
/// thicknesses were all of it exchanged, and stirred. With H the homogeneous layer like this one, N the
/// layer of the other paint, M that of (1 - share) H and share N stirred, and F flecks (flecked()):
///
///     F(layer, N) + M - F(H, N)
///
/// so a share of 0 changes nothing and one of 1 gives N, whatever the layer is made of.
LayerOptics<double> stirred(const LayerOptics<double>& layer, const OpticalThickness& other,
                            double share);

}  // namespace pastoso::pigment

// What a layer of paint does to light, apart from what lies below it, so that layers can be put on top
// of one another, hidden and moved (Kubelka 1954, "New contributions to the optics of intensely light-
// scattering materials II: nonhomogeneous layers"). All inside the binder, one band of the spectrum.
#pragma once

#include "pigment/kubelka_munk.hpp"

namespace pastoso::pigment {

/// Shares of the light that falls on a layer, 0 to 1. No layer of paint reflects all of it.
template <class Real>
struct LayerOptics {
    Real reflectance;    ///< from above
    Real transmittance;  ///< the same in both directions (Helmholtz)
    Real reverse;        ///< reflectance from below
};

/// Nothing at all.
template <class Real>
inline constexpr LayerOptics<Real> kClearLayer{Real{0}, Real{1}, Real{0}};

/// A homogeneous layer of optical thicknesses K h and S h (both >= 0). With r and x as in
/// layer_reflectance() and e = exp(-x):
///
///     R = r (1 - e^2) / (1 - r^2 e^2),   T = e (1 - r^2) / (1 - r^2 e^2)
template <class Real>
[[gnu::always_inline]] inline LayerOptics<Real> layer_optics(Real kh, Real sh) {
    const Real floor = static_cast<Real>(1e-5) * sh;
    kh = (kh > floor ? kh : floor) + static_cast<Real>(1e-9);
    const Real x = std::sqrt(kh * (kh + 2 * sh));
    const Real thick = sh / (sh + kh + x);
    const Real e = exp_of_negative(-x);
    const Real shared = 1 / (1 - thick * thick * e * e);
    const Real reflectance = thick * (1 - e * e) * shared;
    return {reflectance, e * (1 - thick * thick) * shared, reflectance};
}

/// Reflectance of a layer over a ground: R + T^2 g / (1 - Q g), Q the reverse reflectance.
template <class Real>
[[gnu::always_inline]] inline Real reflectance_over(const LayerOptics<Real>& layer, Real ground) {
    return layer.reflectance +
           layer.transmittance * layer.transmittance * ground / (1 - layer.reverse * ground);
}

/// Two layers as one: light goes to and fro between them.
template <class Real>
[[gnu::always_inline]] inline LayerOptics<Real> laid_over(const LayerOptics<Real>& upper,
                                                          const LayerOptics<Real>& lower) {
    const Real passes = 1 / (1 - upper.reverse * lower.reflectance);
    return {upper.reflectance + upper.transmittance * upper.transmittance * lower.reflectance * passes,
            upper.transmittance * lower.transmittance * passes,
            lower.reverse + lower.transmittance * lower.transmittance * upper.reverse * passes};
}

/// A layer that covers a share of its area, as seen by light that wanders between what is covered and
/// what is not: every share is mixed with that of nothing. 0 is nothing, 1 the layer itself.
template <class Real>
[[gnu::always_inline]] inline LayerOptics<Real> faded(const LayerOptics<Real>& layer, Real opacity) {
    return {opacity * layer.reflectance, opacity * layer.transmittance + (1 - opacity),
            opacity * layer.reverse};
}

/// Two layers side by side in flecks too fine to be seen, the second on a share of the area, in the same
/// light, which wanders between them as in faded(): every share is the mean by area (Neugebauer 1937).
template <class Real>
[[gnu::always_inline]] inline LayerOptics<Real> flecked(const LayerOptics<Real>& first,
                                                        const LayerOptics<Real>& second, Real share) {
    const auto mean = [share](Real a, Real b) { return (1 - share) * a + share * b; };
    return {mean(first.reflectance, second.reflectance), mean(first.transmittance, second.transmittance),
            mean(first.reverse, second.reverse)};
}

/// A layer that looks, over whatever ground, like opaque paint on a share of the area: as seen through
/// the surface, share * outside + (1 - share) * what is seen of the ground, both as light that leaves it.
/// `outside` is the paint's reflectance after the surface. What the surface does (through_surface(), with
/// p = (1 - k1)(1 - k2) and k = k2) is undone, the two are mixed, and what comes of it is again of the
/// form of reflectance_over():
///
///     D = p + k share outside
///     R = share outside / D,   T = p sqrt(1 - share) / D,   Q = k share (p + k outside) / D
///
/// Laying such layers over one another gives what mixing what is seen gives. Between 0 and 1 it is no
/// layer that could be made of paint: R + T may be above 1.
template <class Real>
[[gnu::always_inline]] inline LayerOptics<Real> laid_in_part(Real outside, Real share) {
    constexpr Real kPassed =
        static_cast<Real>((1.0 - kExternalReflection) * (1.0 - kInternalReflection));
    constexpr Real kReturned = static_cast<Real>(kInternalReflection);
    const Real whole = 1 / (kPassed + kReturned * share * outside);
    return {share * outside * whole, kPassed * std::sqrt(1 - share) * whole,
            kReturned * share * (kPassed + kReturned * outside) * whole};
}

}  // namespace pastoso::pigment

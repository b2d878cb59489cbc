// Light in a layer of paint after Kubelka and Munk (1931), and through its surface after Saunderson
// (1942). The functions are free of branches and of library calls in single precision, so that loops
// over cells are vectorised and give the same bits on every machine; they are inlined wherever they are
// used because the kernels are compiled once per instruction set (core/isa.hpp).
#pragma once

#include "pigment/bands.hpp"

#include <bit>
#include <cmath>
#include <cstdint>

namespace pastoso::pigment {

/// Reflection at the surface from outside (k1) and from inside (k2) for a binder of refractive
/// index 1.5.
inline constexpr double kExternalReflection = 0.03;
inline constexpr double kInternalReflection = 0.65;

[[gnu::always_inline]] inline double exp_of_negative(double x) {
    return std::exp(x);
}

/// exp(x) for x <= 0, relative error below 1e-5 (absolute 1e-7): 2^t with t split into the nearest
/// integer and a rest in [-1/2, 1/2], whose power is the polynomial of Cephes' exp2f (Moshier).
[[gnu::always_inline]] inline float exp_of_negative(float x) {
    const float scaled = x * 1.44269504F;
    const float t = scaled > -126.0F ? scaled : -126.0F;
    const auto whole = static_cast<std::int32_t>(t - 0.5F);
    const float f = t - static_cast<float>(whole);
    const float p5 = 1.339887440e-3F + f * 1.535336188e-4F;
    const float p3 = 5.550332471e-2F + f * (9.618437357e-3F + f * p5);
    const float power = 1.0F + f * (6.931472029e-1F + f * (2.402264791e-1F + f * p3));
    return power * std::bit_cast<float>((whole + 127) << 23);
}

/// Reflectance of a layer of optical thicknesses K h and S h (both >= 0) over a ground of reflectance
/// `ground` (0 to 1), all inside the binder. With x = sqrt(Kh (Kh + 2 Sh)), the reflectance of an
/// infinitely thick layer r = Sh / (Sh + Kh + x) and e = exp(-2x):
///
///     R = (n + r d) / (r n + d),   n = (ground - r) e,   d = 1 - r ground
///
/// which equals Kubelka's (1 - Rg (a - b coth bSh)) / (a - Rg + b coth bSh), a = 1 + K/S, b^2 = a^2 - 1,
/// but needs no division by S and no coth: exact limits for thin, thick, clear and black layers. The
/// floor of 1e-5 on K/S keeps a layer that absorbs nothing from 0/0; the whitest pigment has 1.6e-5.
template <class Real>
[[gnu::always_inline]] inline Real layer_reflectance(Real kh, Real sh, Real ground) {
    const Real floor = static_cast<Real>(1e-5) * sh;
    kh = (kh > floor ? kh : floor) + static_cast<Real>(1e-9);
    const Real x = std::sqrt(kh * (kh + 2 * sh));
    const Real thick = sh / (sh + kh + x);
    const Real n = (ground - thick) * exp_of_negative(-2 * x);
    const Real d = 1 - thick * ground;
    return (n + thick * d) / (thick * n + d);
}

/// Reflectance of an infinitely thick layer, 1 / (1 + q + sqrt(q (q + 2))), q = K / S; 0 where nothing
/// scatters.
template <class Real>
[[gnu::always_inline]] inline Real opaque_reflectance(Real k, Real s) {
    return s > 0 ? s / (s + k + std::sqrt(k * (k + 2 * s))) : Real{0};
}

/// What leaves the paint, for light of 1 from outside and the internal reflectance R:
/// (1 - k1)(1 - k2) R / (1 - k2 R). The light reflected outside without entering, k1, is left to the
/// renderer's highlight.
template <class Real>
[[gnu::always_inline]] inline Real through_surface(Real internal) {
    constexpr Real kPassed =
        static_cast<Real>((1.0 - kExternalReflection) * (1.0 - kInternalReflection));
    constexpr Real kReturned = static_cast<Real>(kInternalReflection);
    return kPassed * internal / (1 - kReturned * internal);
}

}  // namespace pastoso::pigment

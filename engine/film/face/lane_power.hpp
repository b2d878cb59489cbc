// Powers for the face formulas. Plain arithmetic on every instruction set, so that all give the same
// bits, which no two mathematical libraries do.
#pragma once

#include "film/face/lanes.hpp"

#include <bit>
#include <cstdint>

namespace pastoso::film::lanes {

#define PASTOSO_LANE_FUNCTION [[gnu::always_inline]] static inline

PASTOSO_LANE_FUNCTION std::int32_t truncated(float a) {
    return static_cast<std::int32_t>(a);
}
PASTOSO_LANE_FUNCTION float real(std::int32_t a) {
    return static_cast<float>(a);
}
PASTOSO_LANE_FUNCTION std::int32_t bits(float a) {
    return std::bit_cast<std::int32_t>(a);
}
PASTOSO_LANE_FUNCTION float from_bits(std::int32_t a) {
    return std::bit_cast<float>(a);
}

template <class Abi>
using IntLanes = stdx::rebind_simd_t<std::int32_t, stdx::simd<float, Abi>>;

template <class Abi>
PASTOSO_LANE_FUNCTION IntLanes<Abi> truncated(stdx::simd<float, Abi> a) {
    return stdx::static_simd_cast<IntLanes<Abi>>(a);
}
template <class Abi>
PASTOSO_LANE_FUNCTION stdx::rebind_simd_t<float, stdx::simd<std::int32_t, Abi>> real(
    stdx::simd<std::int32_t, Abi> a) {
    return stdx::static_simd_cast<stdx::rebind_simd_t<float, stdx::simd<std::int32_t, Abi>>>(a);
}
template <class Abi>
PASTOSO_LANE_FUNCTION IntLanes<Abi> bits(stdx::simd<float, Abi> a) {
    return __builtin_bit_cast(IntLanes<Abi>, a);
}
template <class Abi>
PASTOSO_LANE_FUNCTION stdx::rebind_simd_t<float, stdx::simd<std::int32_t, Abi>> from_bits(
    stdx::simd<std::int32_t, Abi> a) {
    using Floats = stdx::rebind_simd_t<float, stdx::simd<std::int32_t, Abi>>;
    return __builtin_bit_cast(Floats, a);
}

/// Binary logarithm of a positive normal number, to 1e-7 of the larger of itself and 1: the series of
/// artanh((m - 1)/(m + 1)) for the mantissa m in [sqrt(1/2), sqrt(2)).
template <class F>
PASTOSO_LANE_FUNCTION F log2(F x) {
    using Int = decltype(bits(x));
    const Int exponent = (bits(x) - Int(0x3f3504f3)) >> 23;
    const F mantissa = from_bits(Int(bits(x) - (exponent << 23)));
    const F t = (mantissa - F(1.0F)) / (mantissa + F(1.0F));
    const F t2 = t * t;
    const F series =
        F(1.0F) + t2 * (F(1.0F / 3) + t2 * (F(1.0F / 5) + t2 * (F(1.0F / 7) + t2 * F(1.0F / 9))));
    return real(exponent) + F(2.88539008F) * t * series;
}

/// 2^x to 3e-7 of itself for -126 <= x <= 126, the ends of which stand for what lies beyond.
template <class F>
PASTOSO_LANE_FUNCTION F exp2(F x) {
    using Int = decltype(bits(x));
    const F y = lanes::clamp(x, F(-126.0F), F(126.0F));
    const Int whole = truncated(F(y + lanes::copysign(F(0.5F), y)));
    const F f = y - real(whole);
    const F power =
        F(1.0F) +
        f * (F(0.693147181F) +
             f * (F(0.240226507F) +
                  f * (F(0.0555041087F) +
                       f * (F(0.00961812911F) + f * (F(0.00133335581F) + f * F(1.54035304e-4F))))));
    return power * from_bits(Int((whole + Int(127)) << 23));
}

#undef PASTOSO_LANE_FUNCTION

}  // namespace pastoso::film::lanes

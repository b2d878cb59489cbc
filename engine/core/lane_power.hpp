// Powers and roots, in plain arithmetic on every instruction set, so that all give the same bits, which
// no two mathematical libraries do.
#pragma once

#include "core/lanes.hpp"

namespace pastoso::core::lanes {

/// Binary logarithm of a positive normal number, to 1e-7 of the larger of itself and 1: the series of
/// artanh((m - 1)/(m + 1)) for the mantissa m in [sqrt(1/2), sqrt(2)).
template <class F>
PASTOSO_LANE_FUNCTION F log2(F x) {
    using Int = As<std::int32_t, F>;
    const Int exponent = (bits<std::int32_t>(x) - Int(0x3f3504f3)) >> 23;
    const F mantissa = bits<float>(Int(bits<std::int32_t>(x) - (exponent << 23)));
    const F t = (mantissa - F(1.0F)) / (mantissa + F(1.0F));
    const F t2 = t * t;
    const F series =
        F(1.0F) + t2 * (F(1.0F / 3) + t2 * (F(1.0F / 5) + t2 * (F(1.0F / 7) + t2 * F(1.0F / 9))));
    return convert<float>(exponent) + F(2.88539008F) * t * series;
}

/// 2^x to 3e-7 of itself for -126 <= x <= 126, the ends of which stand for what lies beyond.
template <class F>
PASTOSO_LANE_FUNCTION F exp2(F x) {
    using Int = As<std::int32_t, F>;
    const F y = clamp(x, F(-126.0F), F(126.0F));
    const Int whole = convert<std::int32_t>(F(y + copysign(F(0.5F), y)));
    const F f = y - convert<float>(whole);
    const F power =
        F(1.0F) +
        f * (F(0.693147181F) +
             f * (F(0.240226507F) +
                  f * (F(0.0555041087F) +
                       f * (F(0.00961812911F) + f * (F(0.00133335581F) + f * F(1.54035304e-4F))))));
    return power * bits<float>(Int((whole + Int(127)) << 23));
}

/// x^(-1/3) for normal x > 0, relative error below 5e-7: minus a third of the exponent, and Newton's
/// steps, which need no division.
template <class F>
PASTOSO_LANE_FUNCTION F inverse_cube_root(F x) {
    using Bits = As<std::uint32_t, F>;
    constexpr std::uint32_t kFourThirdsOfOne = 0x54A2FA8CU;
    F root = bits<float>(Bits(Bits(kFourThirdsOfOne) - bits<std::uint32_t>(x) / Bits(3U)));
    for (int step = 0; step < 3; ++step)
        root = root * ((F(4.0F) - x * (root * root * root)) * F(1.0F / 3.0F));
    return root;
}

/// The same of x^(1/3).
template <class F>
PASTOSO_LANE_FUNCTION F cube_root(F x) {
    const F inverse = inverse_cube_root(x);
    return x * (inverse * inverse);
}

}  // namespace pastoso::core::lanes

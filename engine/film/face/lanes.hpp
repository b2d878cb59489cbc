// The few operations that the face formulas need, for single floats and for whole SIMD registers alike,
// so that the same formula serves as the fast path and as its own reference.
#pragma once

#include <cmath>
#include <experimental/simd>

namespace pastoso::film::lanes {

namespace stdx = std::experimental;

// Internal linkage and forced inlining: these functions are compiled for several instruction sets, and
// one set's copy must never serve another's.
#define PASTOSO_LANE_FUNCTION [[gnu::always_inline]] static inline

PASTOSO_LANE_FUNCTION float min(float a, float b) {
    return a < b ? a : b;
}
PASTOSO_LANE_FUNCTION float max(float a, float b) {
    return a > b ? a : b;
}
PASTOSO_LANE_FUNCTION float abs(float a) {
    return __builtin_fabsf(a);
}
PASTOSO_LANE_FUNCTION float sqrt(float a) {
    return __builtin_sqrtf(a);
}
PASTOSO_LANE_FUNCTION float copysign(float magnitude, float sign) {
    return __builtin_copysignf(magnitude, sign);
}
PASTOSO_LANE_FUNCTION float select(bool condition, float a, float b) {
    return condition ? a : b;
}
PASTOSO_LANE_FUNCTION bool all(bool condition) {
    return condition;
}
PASTOSO_LANE_FUNCTION bool any(bool condition) {
    return condition;
}

template <class Abi>
PASTOSO_LANE_FUNCTION stdx::simd<float, Abi> min(stdx::simd<float, Abi> a, stdx::simd<float, Abi> b) {
    return stdx::min(a, b);
}
template <class Abi>
PASTOSO_LANE_FUNCTION stdx::simd<float, Abi> max(stdx::simd<float, Abi> a, stdx::simd<float, Abi> b) {
    return stdx::max(a, b);
}
template <class Abi>
PASTOSO_LANE_FUNCTION stdx::simd<float, Abi> abs(stdx::simd<float, Abi> a) {
    return stdx::fabs(a);
}
template <class Abi>
PASTOSO_LANE_FUNCTION stdx::simd<float, Abi> sqrt(stdx::simd<float, Abi> a) {
    return stdx::sqrt(a);
}
template <class Abi>
PASTOSO_LANE_FUNCTION stdx::simd<float, Abi> copysign(stdx::simd<float, Abi> magnitude,
                                                      stdx::simd<float, Abi> sign) {
    return stdx::copysign(magnitude, sign);
}
template <class Abi>
PASTOSO_LANE_FUNCTION stdx::simd<float, Abi> select(stdx::simd_mask<float, Abi> condition,
                                                    stdx::simd<float, Abi> a, stdx::simd<float, Abi> b) {
    stdx::where(condition, b) = a;
    return b;
}

template <class Abi>
PASTOSO_LANE_FUNCTION bool all(stdx::simd_mask<float, Abi> condition) {
    return stdx::all_of(condition);
}
template <class Abi>
PASTOSO_LANE_FUNCTION bool any(stdx::simd_mask<float, Abi> condition) {
    return stdx::any_of(condition);
}

template <class F>
PASTOSO_LANE_FUNCTION F clamp(F value, F low, F high) {
    return lanes::min(lanes::max(value, low), high);
}

#undef PASTOSO_LANE_FUNCTION

}  // namespace pastoso::film::lanes

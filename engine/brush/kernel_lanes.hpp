// Whole SIMD registers of numbers: shared by the kernels of one instruction set.
#pragma once

#include <cstdint>

namespace pastoso::brush::PASTOSO_ISA {
namespace {

#define PASTOSO_KERNEL_INLINE [[maybe_unused, gnu::always_inline]] inline

#if defined(__AVX512F__)
constexpr int kLanes = 16;
#elif defined(__AVX2__)
constexpr int kLanes = 8;
#else
constexpr int kLanes = 4;
#endif
using FloatLanes [[gnu::vector_size(4 * kLanes), gnu::aligned(4), gnu::may_alias]] = float;
using IntLanes [[gnu::vector_size(4 * kLanes), gnu::aligned(4), gnu::may_alias]] = std::int32_t;

/// One number or a register of them, from and to any address.
template <class Lanes, class Value>
PASTOSO_KERNEL_INLINE Lanes load(const Value* from) {
    Lanes lanes;
    __builtin_memcpy(&lanes, from, sizeof lanes);
    return lanes;
}
template <class Lanes, class Value>
PASTOSO_KERNEL_INLINE void store(Value* to, const Lanes& lanes) {
    __builtin_memcpy(to, &lanes, sizeof lanes);
}

/// Both for single numbers and for registers; the second one where either is not a number.
template <class T>
PASTOSO_KERNEL_INLINE T smaller(T a, T b) {
    return a < b ? a : b;
}
template <class T>
PASTOSO_KERNEL_INLINE T larger(T a, T b) {
    return a > b ? a : b;
}

PASTOSO_KERNEL_INLINE float as_floats(std::int32_t values) {
    return static_cast<float>(values);
}
PASTOSO_KERNEL_INLINE FloatLanes as_floats(IntLanes values) {
    return __builtin_convertvector(values, FloatLanes);
}
/// Towards zero.
PASTOSO_KERNEL_INLINE IntLanes as_ints(FloatLanes values) {
    return __builtin_convertvector(values, IntLanes);
}

PASTOSO_KERNEL_INLINE FloatLanes all_lanes(float value) {
    return FloatLanes{} + value;
}

}  // namespace
}  // namespace pastoso::brush::PASTOSO_ISA

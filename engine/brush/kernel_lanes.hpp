// Whole SIMD registers of numbers: shared by the kernels of one instruction set.
#pragma once

#include <cstdint>

#if defined(__AVX512F__) || defined(__AVX2__)
#include <immintrin.h>
#endif

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

using ShortLanes [[gnu::vector_size(2 * kLanes), gnu::aligned(2), gnu::may_alias]] = std::uint16_t;

alignas(4 * kLanes) constexpr std::int32_t kCounting[] = {0, 1, 2,  3,  4,  5,  6,  7,
                                                          8, 9, 10, 11, 12, 13, 14, 15};

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
PASTOSO_KERNEL_INLINE float as_floats(std::uint16_t values) {
    return static_cast<float>(values);
}
PASTOSO_KERNEL_INLINE FloatLanes as_floats(ShortLanes values) {
    return as_floats(__builtin_convertvector(values, IntLanes));
}
/// Towards zero.
PASTOSO_KERNEL_INLINE IntLanes as_ints(FloatLanes values) {
    return __builtin_convertvector(values, IntLanes);
}

PASTOSO_KERNEL_INLINE FloatLanes all_lanes(float value) {
    return FloatLanes{} + value;
}

/// Whether load_chosen() and store_to_chosen() leave the memory of the other lanes alone.
#if defined(__AVX512F__) || defined(__AVX2__)
constexpr bool kMasked = true;
#else
constexpr bool kMasked = false;
#endif

/// Those of consecutive values whose lane of `chosen` is -1 (the others have 0), in the other lanes
/// anything.
template <class Lanes, class Value>
PASTOSO_KERNEL_INLINE Lanes load_chosen(const Value* from, [[maybe_unused]] IntLanes chosen) {
    static_assert(sizeof(Value) == 4 && sizeof(Lanes) == sizeof(IntLanes));
#if defined(__AVX512F__)
    const __mmask16 mask = _mm512_movepi32_mask(reinterpret_cast<__m512i>(chosen));
    return reinterpret_cast<Lanes>(_mm512_maskz_loadu_epi32(mask, from));
#elif defined(__AVX2__)
    const auto* ints = reinterpret_cast<const int*>(from);
    return reinterpret_cast<Lanes>(_mm256_maskload_epi32(ints, reinterpret_cast<__m256i>(chosen)));
#else
    return load<Lanes>(from);
#endif
}
template <class Value>
PASTOSO_KERNEL_INLINE Value load_chosen(const Value* from, bool) {
    return *from;
}

/// Writes them. The other lanes hold what is there already.
template <class Lanes, class Value>
PASTOSO_KERNEL_INLINE void store_to_chosen(Value* to, const Lanes& values,
                                           [[maybe_unused]] IntLanes chosen) {
    static_assert(sizeof(Value) == 4 && sizeof(Lanes) == sizeof(IntLanes));
#if defined(__AVX512F__)
    const __mmask16 mask = _mm512_movepi32_mask(reinterpret_cast<__m512i>(chosen));
    _mm512_mask_storeu_epi32(to, mask, reinterpret_cast<__m512i>(values));
#elif defined(__AVX2__)
    _mm256_maskstore_epi32(reinterpret_cast<int*>(to), reinterpret_cast<__m256i>(chosen),
                           reinterpret_cast<__m256i>(values));
#else
    store(to, values);
#endif
}
template <class Value>
PASTOSO_KERNEL_INLINE void store_to_chosen(Value* to, Value value, bool chosen) {
    if (chosen) *to = value;
}

/// Whether a lane is -1 (the others have 0); true as well where finding out takes longer than it saves.
PASTOSO_KERNEL_INLINE bool may_have_any([[maybe_unused]] IntLanes chosen) {
#if defined(__AVX512F__)
    return _mm512_movepi32_mask(reinterpret_cast<__m512i>(chosen)) != 0;
#elif defined(__AVX2__)
    return _mm256_movemask_ps(reinterpret_cast<__m256>(chosen)) != 0;
#else
    return true;
#endif
}
PASTOSO_KERNEL_INLINE bool may_have_any(bool chosen) {
    return chosen;
}

/// Writes those values whose lane of `chosen` is -1, one after the other (the others have 0), and
/// returns how many. Up to kLanes values are overwritten in all.
PASTOSO_KERNEL_INLINE int store_chosen(std::int32_t* to, IntLanes values, IntLanes chosen) {
#if defined(__AVX512F__)
    const __mmask16 mask = _mm512_movepi32_mask(reinterpret_cast<__m512i>(chosen));
    store(to, _mm512_maskz_compress_epi32(mask, reinterpret_cast<__m512i>(values)));
    return __builtin_popcount(mask);
#else
    int count = 0;
    for (int lane = 0; lane < kLanes; ++lane) {
        to[count] = values[lane];
        count -= chosen[lane];
    }
    return count;
#endif
}

/// table[index] lane by lane, the index taken modulo kLanes. One instruction with GCC.
PASTOSO_KERNEL_INLINE FloatLanes shuffled(FloatLanes table, IntLanes index) {
#if __has_builtin(__builtin_shuffle)
    return __builtin_shuffle(table, index);
#else
    FloatLanes found = {};
    for (int lane = 0; lane < kLanes; ++lane)
        found[lane] = table[index[lane] & (kLanes - 1)];
    return found;
#endif
}

}  // namespace
}  // namespace pastoso::brush::PASTOSO_ISA

// The words of vectorised code, for single numbers and for lanes alike, so that the same formula serves
// as the fast path and as its own reference. All kernels are written in them; what they mean does not
// depend on the instruction set, except where it is said.
#pragma once

#include "core/lane_types.hpp"

#include <bit>

namespace pastoso::core::lanes {

template <class T>
concept Number = std::is_arithmetic_v<T>;

// Single numbers.

/// The second one where either is not a number.
template <Number T>
PASTOSO_LANE_FUNCTION T min(T a, T b) {
    return a < b ? a : b;
}
template <Number T>
PASTOSO_LANE_FUNCTION T max(T a, T b) {
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
template <Number T>
PASTOSO_LANE_FUNCTION T select(bool condition, T a, T b) {
    return condition ? a : b;
}
PASTOSO_LANE_FUNCTION bool all(bool condition) {
    return condition;
}
PASTOSO_LANE_FUNCTION bool any(bool condition) {
    return condition;
}
/// The number in another type; towards zero.
template <Number To, Number T>
PASTOSO_LANE_FUNCTION To convert(T a) {
    return static_cast<To>(a);
}
/// Its bits in another type.
template <Number To, Number T>
PASTOSO_LANE_FUNCTION To bits(T a) {
    return std::bit_cast<To>(a);
}

// Lanes.

// Of floats in whole registers by name: the compiler does not always find the instruction by itself.
template <class T, int N>
PASTOSO_LANE_FUNCTION Lanes<T, N> min(Lanes<T, N> a, Lanes<T, N> b) {
    using V [[maybe_unused]] = Lanes<T, N>;
    [[maybe_unused]] constexpr int kBytes = std::is_same_v<T, float> ? 4 * N : 0;
#if defined(__AVX512F__)
    if constexpr (kBytes == 64) return V(_mm512_min_ps(a.raw, b.raw));
#endif
#if defined(__AVX2__)
    if constexpr (kBytes == 32) return V(_mm256_min_ps(a.raw, b.raw));
#endif
#if defined(__SSE4_1__)
    if constexpr (kBytes == 16) return V(_mm_min_ps(a.raw, b.raw));
#endif
    return V(a.raw < b.raw ? a.raw : b.raw);
}
template <class T, int N>
PASTOSO_LANE_FUNCTION Lanes<T, N> max(Lanes<T, N> a, Lanes<T, N> b) {
    using V [[maybe_unused]] = Lanes<T, N>;
    [[maybe_unused]] constexpr int kBytes = std::is_same_v<T, float> ? 4 * N : 0;
#if defined(__AVX512F__)
    if constexpr (kBytes == 64) return V(_mm512_max_ps(a.raw, b.raw));
#endif
#if defined(__AVX2__)
    if constexpr (kBytes == 32) return V(_mm256_max_ps(a.raw, b.raw));
#endif
#if defined(__SSE4_1__)
    if constexpr (kBytes == 16) return V(_mm_max_ps(a.raw, b.raw));
#endif
    return V(a.raw > b.raw ? a.raw : b.raw);
}
template <class To, class T, int N>
PASTOSO_LANE_FUNCTION Lanes<To, N> convert(Lanes<T, N> a) {
    return Lanes<To, N>(__builtin_convertvector(a.raw, Raw<To, N>));
}
template <class To, class T, int N>
PASTOSO_LANE_FUNCTION auto bits(Lanes<T, N> a) {
    constexpr int kCount = N * static_cast<int>(sizeof(T)) / static_cast<int>(sizeof(To));
    return Lanes<To, kCount>(reinterpret_cast<Raw<To, kCount>>(a.raw));
}
template <int N>
PASTOSO_LANE_FUNCTION Lanes<float, N> abs(Lanes<float, N> a) {
    return bits<float>(bits<std::int32_t>(a) & Lanes<std::int32_t, N>(0x7fffffff));
}
template <int N>
PASTOSO_LANE_FUNCTION Lanes<float, N> copysign(Lanes<float, N> magnitude, Lanes<float, N> sign) {
    const Lanes<std::int32_t, N> rest(0x7fffffff), top(-0x7fffffff - 1);
    return bits<float>((bits<std::int32_t>(magnitude) & rest) | (bits<std::int32_t>(sign) & top));
}
template <int N>
PASTOSO_LANE_FUNCTION Lanes<float, N> sqrt(Lanes<float, N> a) {
#if defined(__AVX512F__)
    if constexpr (N == 16) return Lanes<float, N>(_mm512_sqrt_ps(a.raw));
#endif
#if defined(__AVX2__)
    if constexpr (N == 8) return Lanes<float, N>(_mm256_sqrt_ps(a.raw));
#endif
#if defined(__SSE4_1__)
    if constexpr (N == 4) return Lanes<float, N>(_mm_sqrt_ps(a.raw));
#endif
    Lanes<float, N> roots;
    for (int lane = 0; lane < N; ++lane)
        roots.raw[lane] = __builtin_sqrtf(a.raw[lane]);
    return roots;
}

/// Lane by lane a where the condition holds, else b.
template <class T, int N>
PASTOSO_LANE_FUNCTION Lanes<T, N> select(typename Lanes<T, N>::MaskOf condition, Lanes<T, N> a,
                                         Lanes<T, N> b) {
    [[maybe_unused]] const auto as_floats = [](auto v) {
        return reinterpret_cast<Raw<float, sizeof v / 4>>(v);
    };
    [[maybe_unused]] const auto as_lanes = [](auto v) {
        return Lanes<T, N>(reinterpret_cast<Raw<T, N>>(v));
    };
#if defined(__AVX512F__)
    if constexpr (condition.kIsBits && sizeof(T) == 4)
        return as_lanes(_mm512_mask_blend_ps(condition.value, as_floats(b.raw), as_floats(a.raw)));
    else if constexpr (condition.kIsBits)
        return as_lanes(_mm512_mask_blend_epi64(condition.value, reinterpret_cast<__m512i>(b.raw),
                                                reinterpret_cast<__m512i>(a.raw)));
    else
#endif
#if defined(__AVX2__)
        if constexpr (sizeof a == 32)
        return as_lanes(
            _mm256_blendv_ps(as_floats(b.raw), as_floats(a.raw), as_floats(condition.value)));
    else
#endif
#if defined(__SSE4_1__)
        if constexpr (sizeof a == 16)
        return as_lanes(_mm_blendv_ps(as_floats(b.raw), as_floats(a.raw), as_floats(condition.value)));
    else
#endif
        return Lanes<T, N>(condition.value ? a.raw : b.raw);
}

/// A bit for each lane, the first one lowest.
template <int kBytes, int N>
PASTOSO_LANE_FUNCTION std::uint32_t mask_bits(Mask<kBytes, N> mask) {
    if constexpr (mask.kIsBits) return mask.value;
#if defined(__AVX2__)
    else if constexpr (kBytes * N == 32 && kBytes == 4)
        return static_cast<std::uint32_t>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask.value)));
    else if constexpr (kBytes * N == 32 && kBytes == 8)
        return static_cast<std::uint32_t>(_mm256_movemask_pd(reinterpret_cast<__m256d>(mask.value)));
#endif
#if defined(__SSE4_1__)
    else if constexpr (kBytes * N == 16 && kBytes == 4)
        return static_cast<std::uint32_t>(_mm_movemask_ps(reinterpret_cast<__m128>(mask.value)));
    else if constexpr (kBytes * N == 16 && kBytes == 8)
        return static_cast<std::uint32_t>(_mm_movemask_pd(reinterpret_cast<__m128d>(mask.value)));
#endif
    else {
        std::uint32_t found = 0;
        for (int lane = 0; lane < N; ++lane)
            found |= static_cast<std::uint32_t>(mask.value[lane] != 0) << lane;
        return found;
    }
}
template <int kBytes, int N>
PASTOSO_LANE_FUNCTION bool all(Mask<kBytes, N> mask) {
    return mask_bits(mask) == (1ULL << N) - 1;
}
template <int kBytes, int N>
PASTOSO_LANE_FUNCTION bool any(Mask<kBytes, N> mask) {
    return mask_bits(mask) != 0;
}
/// In how many lanes it holds.
template <int kBytes, int N>
PASTOSO_LANE_FUNCTION int count(Mask<kBytes, N> mask) {
    return __builtin_popcount(mask_bits(mask));
}

/// The largest of all lanes.
template <class T, int N>
PASTOSO_LANE_FUNCTION T largest(Lanes<T, N> a) {
    if constexpr (N == 1) {
        return a.raw[0];
    } else {
        const auto halves = [&]<int... kLane>(std::integer_sequence<int, kLane...>) {
            return max(Lanes<T, N / 2>(__builtin_shufflevector(a.raw, a.raw, kLane...)),
                       Lanes<T, N / 2>(__builtin_shufflevector(a.raw, a.raw, (kLane + N / 2)...)));
        };
        return largest(halves(std::make_integer_sequence<int, N / 2>()));
    }
}

// Either.

template <class F>
PASTOSO_LANE_FUNCTION F clamp(F value, F low, F high) {
    return min(max(value, low), high);
}

}  // namespace pastoso::core::lanes

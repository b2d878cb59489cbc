// Lanes<T, N>: N numbers worked on at once, in one or more SIMD registers, and Mask, what comparing them
// gives. Arithmetic is that of T, lane by lane, and so the same on every instruction set.
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

#if defined(__SSE4_1__)
#include <immintrin.h>
#endif

/// Code in lanes is compiled for several instruction sets, and one set's copy of a function must never
/// serve another's: internal linkage and forced inlining.
#define PASTOSO_LANE_FUNCTION [[maybe_unused, gnu::always_inline]] static inline
#define PASTOSO_LANE_MEMBER [[gnu::always_inline]]

// Lanes are passed between inlined functions alone, so that it does not matter how they would be.
#pragma GCC diagnostic ignored "-Wpsabi"

// The sets have types of their own: none is laid out in two ways.
namespace pastoso::core::lanes {
#if defined(__AVX512F__)
inline namespace avx512 {
inline constexpr int kRegisterBytes = 64;
#elif defined(__AVX2__)
inline namespace avx2 {
inline constexpr int kRegisterBytes = 32;
#else
inline namespace baseline {
inline constexpr int kRegisterBytes = 16;
#endif

template <int kBytes>
using IntOf =
    std::conditional_t<kBytes == 8, std::int64_t,
                       std::conditional_t<kBytes == 4, std::int32_t,
                                          std::conditional_t<kBytes == 2, std::int16_t, std::int8_t>>>;

/// The compiler's own vectors, which a number's alignment is enough for.
template <class T, int kCount>
struct RawVector {
    using type [[gnu::vector_size(sizeof(T) * kCount)]] = T;
};
template <class T, int kCount>
using Raw = typename RawVector<T, kCount>::type;

/// One truth value a lane: whole registers of AVX-512 have registers of bits for them, all others lanes
/// of 0 and -1.
template <int kBytes, int kCount>
struct Mask {
    static constexpr bool kIsBits = kRegisterBytes == 64 && kBytes * kCount == 64 && kBytes >= 4;
    using Bits = std::conditional_t<kCount == 16, std::uint16_t, std::uint8_t>;
    using Value = std::conditional_t<kIsBits, Bits, Raw<IntOf<kBytes>, kCount>>;
    Value value;

    PASTOSO_LANE_MEMBER friend Mask operator&&(Mask a, Mask b) {
#if defined(__AVX512F__)
        if constexpr (kIsBits && kCount == 16) return {_kand_mask16(a.value, b.value)};
        if constexpr (kIsBits && kCount == 8) return {_kand_mask8(a.value, b.value)};
#endif
        return {static_cast<Value>(a.value & b.value)};
    }
    PASTOSO_LANE_MEMBER friend Mask operator||(Mask a, Mask b) {
#if defined(__AVX512F__)
        if constexpr (kIsBits && kCount == 16) return {_kor_mask16(a.value, b.value)};
        if constexpr (kIsBits && kCount == 8) return {_kor_mask8(a.value, b.value)};
#endif
        return {static_cast<Value>(a.value | b.value)};
    }
    PASTOSO_LANE_MEMBER friend Mask operator!(Mask a) {
#if defined(__AVX512F__)
        if constexpr (kIsBits && kCount == 16) return {_knot_mask16(a.value)};
        if constexpr (kIsBits && kCount == 8) return {_knot_mask8(a.value)};
#endif
        return {static_cast<Value>(~a.value)};
    }
    PASTOSO_LANE_MEMBER bool operator[](int lane) const {
        if constexpr (kIsBits)
            return (value >> lane & 1) != 0;
        else
            return value[lane] != 0;
    }
};

enum class Comparison { Equal, Less, AtMost, Unequal };

#if defined(__AVX512F__)
/// Of whole registers.
template <Comparison kHow, class T, int kCount>
PASTOSO_LANE_FUNCTION auto compared_bits(Raw<T, kCount> a, Raw<T, kCount> b) {
    constexpr int kReal[] = {_CMP_EQ_OQ, _CMP_LT_OS, _CMP_LE_OS, _CMP_NEQ_UQ};
    constexpr int kWhole[] = {_MM_CMPINT_EQ, _MM_CMPINT_LT, _MM_CMPINT_LE, _MM_CMPINT_NE};
    constexpr int kOfReals = kReal[static_cast<int>(kHow)], kOfInts = kWhole[static_cast<int>(kHow)];
    if constexpr (std::is_same_v<T, float>)
        return _mm512_cmp_ps_mask(reinterpret_cast<__m512>(a), reinterpret_cast<__m512>(b), kOfReals);
    else if constexpr (std::is_same_v<T, double>)
        return _mm512_cmp_pd_mask(reinterpret_cast<__m512d>(a), reinterpret_cast<__m512d>(b), kOfReals);
    else if constexpr (sizeof(T) == 4 && std::is_signed_v<T>)
        return _mm512_cmp_epi32_mask(reinterpret_cast<__m512i>(a), reinterpret_cast<__m512i>(b),
                                     kOfInts);
    else if constexpr (sizeof(T) == 4)
        return _mm512_cmp_epu32_mask(reinterpret_cast<__m512i>(a), reinterpret_cast<__m512i>(b),
                                     kOfInts);
    else if constexpr (std::is_signed_v<T>)
        return _mm512_cmp_epi64_mask(reinterpret_cast<__m512i>(a), reinterpret_cast<__m512i>(b),
                                     kOfInts);
    else
        return _mm512_cmp_epu64_mask(reinterpret_cast<__m512i>(a), reinterpret_cast<__m512i>(b),
                                     kOfInts);
}
#endif

template <class T, int kCount>
struct Lanes {
    using MaskOf = Mask<static_cast<int>(sizeof(T)), kCount>;
    static constexpr int kLanes = kCount;
    Raw<T, kCount> raw;

    Lanes() = default;
    PASTOSO_LANE_MEMBER explicit Lanes(const Raw<T, kCount>& values) : raw(values) {}
    /// The same number in all lanes.
    PASTOSO_LANE_MEMBER Lanes(T number) : raw(number - Raw<T, kCount>{}) {}
    /// A number for each lane.
    template <class... Numbers>
    requires(sizeof...(Numbers) == kCount && kCount > 1) PASTOSO_LANE_MEMBER Lanes(Numbers... numbers)
        : raw{static_cast<T>(numbers)...} {}

    PASTOSO_LANE_MEMBER T operator[](int lane) const { return raw[lane]; }
    PASTOSO_LANE_MEMBER Lanes operator-() const { return Lanes(-raw); }
    PASTOSO_LANE_MEMBER Lanes& operator+=(Lanes b) { return *this = *this + b; }
    PASTOSO_LANE_MEMBER Lanes& operator-=(Lanes b) { return *this = *this - b; }

    PASTOSO_LANE_MEMBER friend Lanes operator+(Lanes a, Lanes b) { return Lanes(a.raw + b.raw); }
    PASTOSO_LANE_MEMBER friend Lanes operator-(Lanes a, Lanes b) { return Lanes(a.raw - b.raw); }
    PASTOSO_LANE_MEMBER friend Lanes operator*(Lanes a, Lanes b) { return Lanes(a.raw * b.raw); }
    PASTOSO_LANE_MEMBER friend Lanes operator/(Lanes a, Lanes b) { return Lanes(a.raw / b.raw); }
    PASTOSO_LANE_MEMBER friend Lanes operator&(Lanes a, Lanes b) { return Lanes(a.raw & b.raw); }
    PASTOSO_LANE_MEMBER friend Lanes operator|(Lanes a, Lanes b) { return Lanes(a.raw | b.raw); }
    PASTOSO_LANE_MEMBER friend Lanes operator^(Lanes a, Lanes b) { return Lanes(a.raw ^ b.raw); }
    PASTOSO_LANE_MEMBER friend Lanes operator<<(Lanes a, int by) { return Lanes(a.raw << by); }
    PASTOSO_LANE_MEMBER friend Lanes operator>>(Lanes a, int by) { return Lanes(a.raw >> by); }

    PASTOSO_LANE_MEMBER friend MaskOf operator==(Lanes a, Lanes b) {
        return compared<Comparison::Equal>(a, b);
    }
    PASTOSO_LANE_MEMBER friend MaskOf operator!=(Lanes a, Lanes b) {
        return compared<Comparison::Unequal>(a, b);
    }
    PASTOSO_LANE_MEMBER friend MaskOf operator<(Lanes a, Lanes b) {
        return compared<Comparison::Less>(a, b);
    }
    PASTOSO_LANE_MEMBER friend MaskOf operator<=(Lanes a, Lanes b) {
        return compared<Comparison::AtMost>(a, b);
    }
    PASTOSO_LANE_MEMBER friend MaskOf operator>(Lanes a, Lanes b) { return b < a; }
    PASTOSO_LANE_MEMBER friend MaskOf operator>=(Lanes a, Lanes b) { return b <= a; }

  private:
    template <Comparison kHow>
    PASTOSO_LANE_MEMBER static MaskOf compared(Lanes a, Lanes b) {
#if defined(__AVX512F__)
        if constexpr (MaskOf::kIsBits)
            return {compared_bits<kHow, T, kCount>(a.raw, b.raw)};
        else
#endif
            if constexpr (kHow == Comparison::Equal)
            return {a.raw == b.raw};
        else if constexpr (kHow == Comparison::Unequal)
            return {a.raw != b.raw};
        else if constexpr (kHow == Comparison::Less)
            return {a.raw < b.raw};
        else
            return {a.raw <= b.raw};
    }
};

/// As many numbers as fill a register.
template <class T>
using Widest = Lanes<T, kRegisterBytes / static_cast<int>(sizeof(T))>;
/// As many numbers as V has, of another type.
template <class T, class V>
struct Another {
    using type = Lanes<T, V::kLanes>;
};
template <class T, class V>
requires std::is_arithmetic_v<V>
struct Another<T, V> {
    using type = T;
};
template <class T, class V>
using As = typename Another<T, V>::type;

}  // namespace
}  // namespace pastoso::core::lanes

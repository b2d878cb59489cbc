// Lanes from and to memory, and from lane to lane.
#pragma once

#include "core/lanes.hpp"

namespace pastoso::core::lanes {

/// Lanes wherever they lie. Copied as bytes they would go through memory in halves, as GCC does it in
/// large functions, and a processor waits where it then reads the halves as one.
template <class V>
struct Anywhere {
    using Raw [[gnu::may_alias, gnu::aligned(1)]] = decltype(V::raw);
};

/// Neighbouring numbers, or a single one, from any address.
template <class V, class T>
PASTOSO_LANE_FUNCTION V load(const T* from) {
    static_assert(std::is_same_v<As<T, V>, V>);
    if constexpr (Number<V>) {
        return *from;
    } else {
        V values;
        values.raw = *reinterpret_cast<const typename Anywhere<V>::Raw*>(from);
        return values;
    }
}
template <class T, class V>
PASTOSO_LANE_FUNCTION void store(T* to, const V& values) {
    if constexpr (Number<V>)
        *to = values;
    else
        *reinterpret_cast<typename Anywhere<V>::Raw*>(to) = values.raw;
}

/// of(0), of(1), ...
template <class V, class Of>
PASTOSO_LANE_FUNCTION V generate(const Of& of) {
    return [&]<int... kLane>(std::integer_sequence<int, kLane...>) PASTOSO_LANE_MEMBER {
        return V(of(kLane)...);
    }
    (std::make_integer_sequence<int, V::kLanes>());
}
/// 0, 1, 2, ...; of a single number 0.
template <class V>
PASTOSO_LANE_FUNCTION V counting() {
    if constexpr (Number<V>)
        return V(0);
    else
        return generate<V>([](int lane) PASTOSO_LANE_MEMBER { return lane; });
}
/// table[index], lane by lane.
template <class T, int N>
PASTOSO_LANE_FUNCTION Lanes<T, N> gather(const T* table, Lanes<std::int32_t, N> index) {
    return generate<Lanes<T, N>>([&](int lane) PASTOSO_LANE_MEMBER { return table[index[lane]]; });
}

/// The lanes of `low` and behind them those of `high`.
template <class T, int N>
PASTOSO_LANE_FUNCTION Lanes<T, 2 * N> joined(Lanes<T, N> low, Lanes<T, N> high) {
    return [&]<int... kLane>(std::integer_sequence<int, kLane...>) PASTOSO_LANE_MEMBER {
        return Lanes<T, 2 * N>(__builtin_shufflevector(low.raw, high.raw, kLane...));
    }
    (std::make_integer_sequence<int, 2 * N>());
}
/// The first half of the lanes (0) or the second (1).
template <int kHalf, class T, int N>
PASTOSO_LANE_FUNCTION Lanes<T, N / 2> half_of(Lanes<T, N> both) {
    return [&]<int... kLane>(std::integer_sequence<int, kLane...>) PASTOSO_LANE_MEMBER {
        return Lanes<T, N / 2>(__builtin_shufflevector(both.raw, both.raw, (kLane + kHalf * N / 2)...));
    }
    (std::make_integer_sequence<int, N / 2>());
}

/// Four registers' worth of lanes.
template <class V>
struct FourRows {
    V row[4];
};
/// In each quarter register of four lanes, what is in rows becomes columns.
template <class T, int N>
PASTOSO_LANE_FUNCTION FourRows<Lanes<T, N>> turned(const FourRows<Lanes<T, N>>& from) {
    using V = Lanes<T, N>;
    // Lanes 0 and 1, or 2 and 3, of each four of a and b by turns.
    const auto low = [](V a, V b) PASTOSO_LANE_MEMBER {
        return [&]<int... kLane>(std::integer_sequence<int, kLane...>) PASTOSO_LANE_MEMBER {
            return V(__builtin_shufflevector(a.raw, b.raw,
                                             (kLane / 4 * 4 + kLane % 4 / 2 + kLane % 2 * N)...));
        }
        (std::make_integer_sequence<int, N>());
    };
    const auto high = [](V a, V b) PASTOSO_LANE_MEMBER {
        return [&]<int... kLane>(std::integer_sequence<int, kLane...>) PASTOSO_LANE_MEMBER {
            return V(__builtin_shufflevector(a.raw, b.raw,
                                             (kLane / 4 * 4 + 2 + kLane % 4 / 2 + kLane % 2 * N)...));
        }
        (std::make_integer_sequence<int, N>());
    };
    const V even_low = low(from.row[0], from.row[2]), odd_low = low(from.row[1], from.row[3]),
            even_high = high(from.row[0], from.row[2]), odd_high = high(from.row[1], from.row[3]);
    return {{low(even_low, odd_low), high(even_low, odd_low), low(even_high, odd_high),
             high(even_high, odd_high)}};
}

/// Four neighbouring floats at `at` of each lane: row n holds the nth of all.
template <class V, class At>
PASTOSO_LANE_FUNCTION FourRows<V> load_fours(const At& at) {
    const auto four = [&](int lane) PASTOSO_LANE_MEMBER { return load<Lanes<float, 4>>(at(lane)); };
    FourRows<V> rows;
    for (int n = 0; n < 4; ++n) {
        if constexpr (V::kLanes == 4)
            rows.row[n] = four(n);
        else if constexpr (V::kLanes == 8)
            rows.row[n] = joined(four(n), four(n + 4));
        else
            rows.row[n] = joined(joined(four(n), four(n + 4)), joined(four(n + 8), four(n + 12)));
    }
    return turned(rows);
}
/// The other way.
template <class V, class At>
PASTOSO_LANE_FUNCTION void store_fours(const FourRows<V>& of, const At& at) {
    const FourRows<V> rows = turned(of);
    for (int n = 0; n < 4; ++n) {
        if constexpr (V::kLanes == 4) {
            store(at(n), rows.row[n]);
        } else if constexpr (V::kLanes == 8) {
            store(at(n), half_of<0>(rows.row[n]));
            store(at(n + 4), half_of<1>(rows.row[n]));
        } else {
            const auto first = half_of<0>(rows.row[n]), second = half_of<1>(rows.row[n]);
            store(at(n), half_of<0>(first));
            store(at(n + 4), half_of<1>(first));
            store(at(n + 8), half_of<0>(second));
            store(at(n + 12), half_of<1>(second));
        }
    }
}

/// Whether load_where() and store_where() leave the memory of the other lanes alone.
constexpr bool kMasked = kRegisterBytes > 16;

/// Those of a register's worth of neighbouring numbers where the mask holds, 0 or what is there in the
/// other lanes.
template <class V, class T, int N>
PASTOSO_LANE_FUNCTION V load_where(const T* from, [[maybe_unused]] Mask<4, N> mask) {
    static_assert(sizeof(T) == 4 && sizeof(V) == kRegisterBytes);
#if defined(__AVX512F__)
    return V(reinterpret_cast<decltype(V::raw)>(_mm512_maskz_loadu_epi32(mask.value, from)));
#elif defined(__AVX2__)
    const auto* ints = reinterpret_cast<const int*>(from);
    return V(reinterpret_cast<decltype(V::raw)>(
        _mm256_maskload_epi32(ints, reinterpret_cast<__m256i>(mask.value))));
#else
    return load<V>(from);
#endif
}
template <class V, class T>
PASTOSO_LANE_FUNCTION V load_where(const T* from, bool) {
    return *from;
}

/// Writes them; the other lanes hold what is there already.
template <class T, class V, int N>
PASTOSO_LANE_FUNCTION void store_where(T* to, const V& values, [[maybe_unused]] Mask<4, N> mask) {
    static_assert(sizeof(T) == 4 && sizeof(V) == kRegisterBytes);
#if defined(__AVX512F__)
    _mm512_mask_storeu_epi32(to, mask.value, reinterpret_cast<__m512i>(values.raw));
#elif defined(__AVX2__)
    _mm256_maskstore_epi32(reinterpret_cast<int*>(to), reinterpret_cast<__m256i>(mask.value),
                           reinterpret_cast<__m256i>(values.raw));
#else
    store(to, values);
#endif
}
template <class T>
PASTOSO_LANE_FUNCTION void store_where(T* to, T value, bool condition) {
    if (condition) *to = value;
}

/// any(), but true as well where finding out takes longer than it saves.
template <int kBytes, int N>
PASTOSO_LANE_FUNCTION bool may_have_any([[maybe_unused]] Mask<kBytes, N> mask) {
    if constexpr (kMasked) return any(mask);
    return true;
}
PASTOSO_LANE_FUNCTION bool may_have_any(bool condition) {
    return condition;
}

/// The lanes of each mask of eight, packed: those where it holds, one after the other, then any.
struct PackedLanes {
    std::uint8_t of[256][8] = {};

    constexpr PackedLanes() {
        for (int mask = 0; mask < 256; ++mask)
            for (int lane = 0, count = 0; lane < 8; ++lane)
                if ((mask >> lane & 1) != 0) of[mask][count++] = static_cast<std::uint8_t>(lane);
    }
};
inline constexpr PackedLanes kPackedLanes;

/// Writes the numbers where the mask holds, one after the other, and returns how many. Up to N numbers
/// are overwritten in all.
template <int N>
PASTOSO_LANE_FUNCTION int store_compressed(std::int32_t* to, Lanes<std::int32_t, N> values,
                                           Mask<4, N> mask) {
#if defined(__AVX512F__)
    if constexpr (mask.kIsBits) {
        const __m512i first =
            _mm512_maskz_compress_epi32(mask.value, reinterpret_cast<__m512i>(values.raw));
        __builtin_memcpy(to, &first, sizeof first);
        return __builtin_popcount(mask.value);
    } else
#elif defined(__AVX2__)
    if constexpr (N == 8) {
        const int bits = _mm256_movemask_ps(reinterpret_cast<__m256>(mask.value));
        const __m256i lanes = _mm256_cvtepu8_epi32(
            _mm_loadl_epi64(reinterpret_cast<const __m128i*>(kPackedLanes.of[bits])));
        const __m256i first = _mm256_permutevar8x32_epi32(reinterpret_cast<__m256i>(values.raw), lanes);
        __builtin_memcpy(to, &first, sizeof first);
        return __builtin_popcount(static_cast<unsigned>(bits));
    } else
#endif
    {
        int count = 0;
        for (int lane = 0; lane < N; ++lane) {
            to[count] = values[lane];
            count -= mask.value[lane];
        }
        return count;
    }
}

/// table[index] lane by lane, the index taken modulo N. One instruction with GCC.
template <class T, int N>
PASTOSO_LANE_FUNCTION Lanes<T, N> shuffled(Lanes<T, N> table, Lanes<std::int32_t, N> index) {
#if __has_builtin(__builtin_shuffle)
    return Lanes<T, N>(__builtin_shuffle(table.raw, index.raw));
#else
    return generate<Lanes<T, N>>([&](int lane) { return table[index[lane] & (N - 1)]; });
#endif
}
/// The lanes kFrom of a, then (from N on) of b.
template <int... kFrom, class T, int N>
PASTOSO_LANE_FUNCTION Lanes<T, sizeof...(kFrom)> permuted(Lanes<T, N> a, Lanes<T, N> b) {
    return Lanes<T, sizeof...(kFrom)>(__builtin_shufflevector(a.raw, b.raw, kFrom...));
}
template <int... kFrom, class T, int N>
PASTOSO_LANE_FUNCTION Lanes<T, sizeof...(kFrom)> permuted(Lanes<T, N> a) {
    return permuted<kFrom...>(a, a);
}

}  // namespace pastoso::core::lanes

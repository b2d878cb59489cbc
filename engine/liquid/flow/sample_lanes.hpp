// Interpolation of one point with four lanes at a time: shared by the kernels of one instruction set
// and, compiled for the baseline, by everybody else. Fields have two samples more than the box on every
// side.
#pragma once

#include <cstddef>

namespace pastoso::liquid {
namespace {

/// Four neighbours along x, or x, y, z and 0.
using Four [[gnu::vector_size(16)]] = float;
using FourInts [[gnu::vector_size(16)]] = int;

#define PASTOSO_LIQUID_INLINE [[maybe_unused, gnu::always_inline]] static inline

PASTOSO_LIQUID_INLINE Four load(const float* values) {
    Four four;
    __builtin_memcpy(&four, values, sizeof(four));
    return four;
}
PASTOSO_LIQUID_INLINE Four all(float value) {
    return Four{value, value, value, value};
}
PASTOSO_LIQUID_INLINE Four least(Four a, Four b) {
    return a < b ? a : b;
}
PASTOSO_LIQUID_INLINE Four greatest(Four a, Four b) {
    return a > b ? a : b;
}
PASTOSO_LIQUID_INLINE Four mixed(Four a, Four b, float share) {
    return a + all(share) * (b - a);
}

/// The sample before a place, and how far behind it the place lies, 0 to 1.
struct Place {
    std::ptrdiff_t index;
    Four share;
};
/// Of a place in sample coordinates, all of them above -2.
PASTOSO_LIQUID_INLINE Place place_of(Four at, std::ptrdiff_t stride_y, std::ptrdiff_t stride_z) {
    const Four shifted = at + all(2.0F);
    const FourInts whole = __builtin_convertvector(shifted, FourInts);
    return {(whole[0] - 2) + (whole[1] - 2) * stride_y + (whole[2] - 2) * stride_z,
            shifted - __builtin_convertvector(whole, Four)};
}

/// Four interleaved values per sample.
PASTOSO_LIQUID_INLINE Four linear_of_four(const float* centres, const Place& place, std::ptrdiff_t y,
                                          std::ptrdiff_t z) {
    const float* at = centres + 4 * place.index;
    const auto row = [&](std::ptrdiff_t offset) {
        return mixed(load(at + 4 * offset), load(at + 4 * offset + 4), place.share[0]);
    };
    return mixed(mixed(row(0), row(y), place.share[1]), mixed(row(z), row(y + z), place.share[1]),
                 place.share[2]);
}

PASTOSO_LIQUID_INLINE float linear(const float* field, const Place& place, std::ptrdiff_t y,
                                   std::ptrdiff_t z) {
    const float* at = field + place.index;
    const auto row = [&](std::ptrdiff_t offset) {
        return at[offset] + place.share[0] * (at[offset + 1] - at[offset]);
    };
    const auto slice = [&](std::ptrdiff_t offset) {
        const float first = row(offset), second = row(offset + y);
        return first + place.share[1] * (second - first);
    };
    const float low = slice(0), high = slice(z);
    return low + place.share[2] * (high - low);
}

/// Catmull-Rom's weights of the samples -1, 0, 1, 2 at t behind sample 0.
PASTOSO_LIQUID_INLINE Four cubic_weights(float t) {
    const Four cube = {-0.5F, 1.5F, -1.5F, 0.5F}, square = {1.0F, -2.5F, 2.0F, -0.5F},
               single = {-0.5F, 0.0F, 0.5F, 0.0F}, constant = {0.0F, 1.0F, 0.0F, 0.0F};
    const Four at = all(t);
    return ((cube * at + square) * at + single) * at + constant;
}

struct CubicWeights {
    Four x, y, z;
};
PASTOSO_LIQUID_INLINE CubicWeights cubic_weights_at(const Four& share) {
    return {cubic_weights(share[0]), cubic_weights(share[1]), cubic_weights(share[2])};
}

template <bool kLimited>
PASTOSO_LIQUID_INLINE float cubic(const float* field, const Place& place, const CubicWeights& weights,
                                  std::ptrdiff_t y, std::ptrdiff_t z) {
    const float* first = field + place.index - 1 - y - z;
    Four sum = all(0.0F), low = sum, high = sum;
    for (int k = 0; k < 4; ++k) {
        const float* slice = first + k * z;
        const Four r0 = load(slice), r1 = load(slice + y), r2 = load(slice + 2 * y),
                   r3 = load(slice + 3 * y);
        const Four rows = (r0 * all(weights.y[0]) + r1 * all(weights.y[1])) +
                          (r2 * all(weights.y[2]) + r3 * all(weights.y[3]));
        sum += rows * all(weights.z[k]);
        if (kLimited && (k == 1 || k == 2)) {
            const Four lower = least(r1, r2), upper = greatest(r1, r2);
            low = k == 1 ? lower : least(low, lower);
            high = k == 1 ? upper : greatest(high, upper);
        }
    }
    const Four product = sum * weights.x;
    const float value = (product[0] + product[1]) + (product[2] + product[3]);
    if constexpr (!kLimited) return value;
    const float floor = low[1] < low[2] ? low[1] : low[2];
    const float ceiling = high[1] > high[2] ? high[1] : high[2];
    return value < floor ? floor : value > ceiling ? ceiling : value;
}

/// Puts a point back into the box, in cell units.
template <bool kPeriodic>
PASTOSO_LIQUID_INLINE Four in_box(Four at, Four size) {
    if constexpr (kPeriodic) {
        const Four turns = at / size;
        const Four toward_zero = __builtin_convertvector(__builtin_convertvector(turns, FourInts), Four);
        const Four whole = toward_zero - (turns < toward_zero ? all(1.0F) : all(0.0F));
        at -= whole * size;
    }
    return least(greatest(at, all(0.0F)), size);
}

/// Where the samples of the faces across an axis lie within their cell; axis 3: of the middles.
PASTOSO_LIQUID_INLINE Four location_of(int axis) {
    return Four{axis == 0 ? 0.0F : 0.5F, axis == 1 ? 0.0F : 0.5F, axis == 2 ? 0.0F : 0.5F, 0.0F};
}

}  // namespace
}  // namespace pastoso::liquid

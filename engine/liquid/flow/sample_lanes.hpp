// Interpolation of one point with four lanes at a time: shared by the kernels of one instruction set
// and, compiled for the baseline, by everybody else. Fields have two samples more than the box on every
// side.
#pragma once

#include "core/lane_memory.hpp"

#include <cstddef>

namespace pastoso::liquid {
namespace {

namespace lanes = core::lanes;

/// Four neighbours along x, or x, y, z and 0.
using Four = lanes::Lanes<float, 4>;

/// The sample before a place, and how far behind it the place lies, 0 to 1.
struct Place {
    std::ptrdiff_t index;
    Four share;
};
/// Of a place in sample coordinates, all of them above -2.
PASTOSO_LANE_FUNCTION Place place_of(Four at, std::ptrdiff_t stride_y, std::ptrdiff_t stride_z) {
    const Four shifted = at + Four(2.0F);
    const auto whole = lanes::convert<std::int32_t>(shifted);
    return {(whole[0] - 2) + (whole[1] - 2) * stride_y + (whole[2] - 2) * stride_z,
            shifted - lanes::convert<float>(whole)};
}

PASTOSO_LANE_FUNCTION float linear(const float* field, const Place& place, std::ptrdiff_t y,
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
PASTOSO_LANE_FUNCTION Four cubic_weights(float t) {
    const Four cube = {-0.5F, 1.5F, -1.5F, 0.5F}, square = {1.0F, -2.5F, 2.0F, -0.5F},
               single = {-0.5F, 0.0F, 0.5F, 0.0F}, constant = {0.0F, 1.0F, 0.0F, 0.0F};
    const Four at = Four(t);
    return ((cube * at + square) * at + single) * at + constant;
}

struct CubicWeights {
    Four x, y, z;
};
PASTOSO_LANE_FUNCTION CubicWeights cubic_weights_at(const Four& share) {
    return {cubic_weights(share[0]), cubic_weights(share[1]), cubic_weights(share[2])};
}

template <bool kLimited>
PASTOSO_LANE_FUNCTION float cubic(const float* field, const Place& place, const CubicWeights& weights,
                                  std::ptrdiff_t y, std::ptrdiff_t z) {
    const float* first = field + place.index - 1 - y - z;
    Four sum = Four(0.0F), low = sum, high = sum;
    for (int k = 0; k < 4; ++k) {
        const float* slice = first + k * z;
        const Four r0 = lanes::load<Four>(slice), r1 = lanes::load<Four>(slice + y),
                   r2 = lanes::load<Four>(slice + 2 * y), r3 = lanes::load<Four>(slice + 3 * y);
        const Four rows = (r0 * Four(weights.y[0]) + r1 * Four(weights.y[1])) +
                          (r2 * Four(weights.y[2]) + r3 * Four(weights.y[3]));
        sum += rows * Four(weights.z[k]);
        if (kLimited && (k == 1 || k == 2)) {
            const Four lower = lanes::min(r1, r2), upper = lanes::max(r1, r2);
            low = k == 1 ? lower : lanes::min(low, lower);
            high = k == 1 ? upper : lanes::max(high, upper);
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
PASTOSO_LANE_FUNCTION Four in_box(Four at, Four size) {
    if constexpr (kPeriodic) {
        const Four turns = at / size;
        const Four toward_zero = lanes::convert<float>(lanes::convert<std::int32_t>(turns));
        const Four whole = toward_zero - lanes::select(turns < toward_zero, Four(1.0F), Four(0.0F));
        at -= whole * size;
    }
    return lanes::min(lanes::max(at, Four(0.0F)), size);
}

/// Where the samples of the faces across an axis lie within their cell; axis 3: of the middles.
PASTOSO_LANE_FUNCTION Four location_of(int axis) {
    return Four{axis == 0 ? 0.0F : 0.5F, axis == 1 ? 0.0F : 0.5F, axis == 2 ? 0.0F : 0.5F, 0.0F};
}

}  // namespace
}  // namespace pastoso::liquid

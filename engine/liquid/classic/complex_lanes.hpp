// Two complex numbers side by side in the four lanes of a Four: real, imaginary, real, imaginary.
#pragma once

#include "liquid/flow/sample_lanes.hpp"

namespace pastoso::liquid {
namespace {

inline constexpr int kNumbersAtOnce = 2;

PASTOSO_LANE_FUNCTION Four parts_swapped(Four v) {
    return lanes::permuted<1, 0, 3, 2>(v);
}
PASTOSO_LANE_FUNCTION Four numbers_swapped(Four v) {
    return lanes::permuted<2, 3, 0, 1>(v);
}
PASTOSO_LANE_FUNCTION Four conjugate(Four v) {
    return v * Four{1.0F, -1.0F, 1.0F, -1.0F};
}

/// A factor of complex numbers: its real part, and its imaginary part with the signs that it has in a
/// product.
struct Turn {
    Four real, imaginary;
    Turn(Four real_parts, Four imaginary_parts) : real(real_parts), imaginary(imaginary_parts) {}
};
PASTOSO_LANE_FUNCTION Four times(Four v, const Turn& w) {
    return v * w.real + parts_swapped(v) * w.imaginary;
}
PASTOSO_LANE_FUNCTION Four times_conjugate(Four v, const Turn& w) {
    return v * w.real - parts_swapped(v) * w.imaginary;
}

}  // namespace
}  // namespace pastoso::liquid

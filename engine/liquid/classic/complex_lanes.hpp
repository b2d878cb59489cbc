// Two complex numbers side by side in the four lanes of a Four: real, imaginary, real, imaginary.
#pragma once

#include "liquid/flow/sample_lanes.hpp"

#include <complex>

namespace pastoso::liquid {
namespace {

inline constexpr int kNumbersAtOnce = 2;

PASTOSO_LIQUID_INLINE void store(Four four, float* values) {
    __builtin_memcpy(values, &four, sizeof(four));
}
PASTOSO_LIQUID_INLINE Four parts_swapped(Four v) {
    return __builtin_shufflevector(v, v, 1, 0, 3, 2);
}
PASTOSO_LIQUID_INLINE Four numbers_swapped(Four v) {
    return __builtin_shufflevector(v, v, 2, 3, 0, 1);
}
PASTOSO_LIQUID_INLINE Four conjugate(Four v) {
    return v * Four{1.0F, -1.0F, 1.0F, -1.0F};
}
PASTOSO_LIQUID_INLINE Four times_i(Four v) {
    return parts_swapped(v) * Four{-1.0F, 1.0F, -1.0F, 1.0F};
}

/// A factor of complex numbers: its real part, and its imaginary part with the signs that it has in a
/// product.
struct Turn {
    Four real, imaginary;
    explicit Turn(std::complex<float> w)
        : real(all(w.real())), imaginary{-w.imag(), w.imag(), -w.imag(), w.imag()} {}
    Turn(Four real_parts, Four imaginary_parts) : real(real_parts), imaginary(imaginary_parts) {}
};
PASTOSO_LIQUID_INLINE Four times(Four v, const Turn& w) {
    return v * w.real + parts_swapped(v) * w.imaginary;
}
PASTOSO_LIQUID_INLINE Four times_conjugate(Four v, const Turn& w) {
    return v * w.real - parts_swapped(v) * w.imaginary;
}

}  // namespace
}  // namespace pastoso::liquid

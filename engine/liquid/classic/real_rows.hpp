// The Fourier transform of rows of real numbers by way of complex ones, for FFTW does those several
// times faster: of n real numbers x(0), x(1), .. the pairs are taken for n/2 complex ones, z(j) = x(2j)
// + i x(2j + 1), whose transform Z holds that of x,
//     X(k) = (Z(k) + Z*(n/2 - k)) / 2 - i w^k (Z(k) - Z*(n/2 - k)) / 2,   w = exp(-2 pi i / n).
#pragma once

#include "liquid/flow/aligned_floats.hpp"

namespace pastoso::liquid {

class RealRows {
  public:
    /// n is even, 2 and more.
    explicit RealRows(int n);

    /// From Z(0 .. n/2 - 1) to X(0 .. n/2), in place.
    void unfold(float* row) const;

    /// From X to 2 Z, so that a backward transform of it gives n times x.
    void fold(float* row) const;

  private:
    int half_;
    /// -i w^k for 0 < k <= n/4, as two lanes of a number each have it: real parts twice, imaginary ones
    /// with the signs of a product.
    AlignedFloats real_, imaginary_;
};

}  // namespace pastoso::liquid

// The three-dimensional Fourier transform of real values in a box, by FFTW in single precision. A box is
// cut into plane transforms of its slices and bundles of transforms across them, which the threads of a
// pool share: each is done whole by one thread and by a plan made without measuring, so that the bits do
// not depend on threads, time or what ran before.
#pragma once

#include "core/thread_pool.hpp"
#include "liquid/aligned_floats.hpp"

#include <array>
#include <complex>
#include <cstddef>
#include <memory>

namespace pastoso::liquid {

struct FourierExtent {
    int nx = 0, ny = 0, nz = 0;

    int half() const { return nx / 2 + 1; }  ///< complex values of a row: frequencies 0 to nx/2
    /// Between rows, even so that all rows begin alike for the processor's registers.
    std::ptrdiff_t row_stride() const { return (half() + 1) / 2 * 2; }
    std::ptrdiff_t slice_stride() const { return row_stride() * ny; }
    std::size_t count() const { return static_cast<std::size_t>(slice_stride() * nz); }
};

/// Real values lie in the rows of the complex ones, 2 row_stride() floats apart; the transform is in
/// place.
class FourierBox {
  public:
    explicit FourierBox(const FourierExtent& extent);
    ~FourierBox();
    FourierBox(FourierBox&&) noexcept;
    FourierBox& operator=(FourierBox&&) noexcept;

    const FourierExtent& extent() const { return extent_; }
    float* real_row(int j, int k) {
        return values_.data() + 2 * (j * extent_.row_stride() + k * extent_.slice_stride());
    }
    std::complex<float>* row(int j, int k) {
        return reinterpret_cast<std::complex<float>*>(real_row(j, k));
    }

    void forward(core::ThreadPool& pool);
    /// The sum without dividing: nx ny nz times what forward() was given.
    void backward(core::ThreadPool& pool);

  private:
    struct Plans;
    FourierExtent extent_;
    AlignedFloats values_;
    std::shared_ptr<const Plans> plans_;
};

}  // namespace pastoso::liquid

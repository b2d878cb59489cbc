// The three-dimensional Fourier transform of real values in a box, by FFTW in single precision. A box is
// cut into transforms of the rows and columns of its slices and bundles of transforms across them, which
// the threads of a pool share: each is done whole by one thread and by a plan made without measuring, so
// that the bits do not depend on threads, time or what ran before.
#pragma once

#include "core/thread_pool.hpp"
#include "liquid/flow/aligned_floats.hpp"

#include <array>
#include <complex>
#include <cstddef>
#include <memory>

namespace pastoso::liquid {

struct FourierExtent {
    static constexpr std::ptrdiff_t kLine = 8;  ///< complex values of a cache line

    int nx = 0, ny = 0, nz = 0;

    int half() const { return nx / 2 + 1; }  ///< complex values of a row: frequencies 0 to nx/2
    /// Between rows, even so that all rows begin alike for the processor's registers.
    std::ptrdiff_t row_stride() const { return (half() + 1) / 2 * 2; }
    /// Between slices: an odd number of cache lines, so that a row in all slices does not have to share
    /// few places of the processor's cache (two and a half times as fast at 128^3).
    std::ptrdiff_t slice_stride() const {
        const std::ptrdiff_t lines = (row_stride() * ny + kLine - 1) / kLine;
        return kLine * (lines + 1 - lines % 2);
    }
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
    void forward_slice(int k);
    void forward_across(int j);
    void backward_across(int j);
    void backward_slice(int k);

    struct Plans;
    FourierExtent extent_;
    AlignedFloats values_;
    std::shared_ptr<const Plans> plans_;
};

}  // namespace pastoso::liquid

// The pressure in a closed box without solids, directly: cosines are the eigenvectors of the 7-point
// Laplacian between insulating walls, with eigenvalues
//     lambda = sum over the axes of 2 - 2 cos(pi k / n).
// The cosine transform is done as Fourier transform of the values in the order 0, 2, 4, .. 5, 3, 1
// (Makhoul 1980), because FFTW's own runs without SIMD and took three times as long.
#pragma once

#include "liquid/classic/fourier.hpp"
#include "liquid/flow/velocity.hpp"

#include <vector>

namespace pastoso::liquid {

class CosinePressure {
  public:
    /// Throws core::InputError for a bad shape.
    explicit CosinePressure(const grid::BoxShape& shape);

    /// Solves: the sum over a cell's inner faces of (p - p_neighbour) = source, with mean 0; the
    /// source's mean is left out. Relative error some 1e-6.
    void solve(const grid::BoxField& source, grid::BoxField& pressure, core::ThreadPool& pool);

    /// Makes the velocity free of divergence; the faces of the box become 0.
    void project(VelocityField& velocity, core::ThreadPool& pool);

  private:
    /// Of one axis: its part of the eigenvalue, and exp(-i pi k / 2n).
    struct Axis {
        std::vector<float> eigenvalue;
        std::vector<std::complex<float>> turn;
    };
    using Slice = std::vector<float>;  ///< nx ny values

    void compute_frequencies_x();
    /// A row of cells, to and from where it is transformed.
    void load_row(const float* source, int j, int k);
    void store_row(int j, int k, float* pressure);
    void load_divergence(const VelocityField& velocity, int k);
    /// Transforms a slice back; its rows are `stride` apart.
    void store_slice(int k, float* pressure, std::ptrdiff_t stride);
    void subtract_gradient(const Slice& pressure, int k, VelocityField& velocity) const;
    void subtract_gradient_z(const Slice& pressure, const Slice& below, int k,
                             VelocityField& velocity) const;
    /// From slices that are transformed to slices that are to be transformed back.
    void divide(core::ThreadPool& pool);
    void divide_across(int ky);
    template <std::size_t kRowsY, std::size_t kRowsZ>
    void divide_rows(int ky, int kz);

    grid::BoxShape shape_;
    FourierBox spectrum_;
    std::array<Axis, 3> axes_;
    /// Along x as the numbers of a row lie: eigenvalues of frequencies kx and nx - kx in turn, and the
    /// factors' real and imaginary parts, each twice, the latter with the signs of a product.
    AlignedFloats eigenvalues_x_, real_x_, imaginary_x_;
};

}  // namespace pastoso::liquid

// What deforms parcels, compiled for every instruction set (pastoso_add_kernels). See parcel_shape.hpp.
#pragma once

#include "core/kernels.hpp"

#include <cstddef>

namespace pastoso::liquid {

/// Of all parcels of a tea.
struct ShapeLimits {
    float most;                 ///< of S along any axis
    float widening_per_strain;  ///< 2 D / (s0^2 |L|): see shape_limits()
};

/// A velocity on faces, and what it does to parcels during a time.
struct DeformationView {
    const float* faces[3];  ///< sample (0, 0, 0) of each component, in m/s
    std::ptrdiff_t stride_y, stride_z;
    int cells[3];
    float cell_m, dt_s;
    ShapeLimits limits;
};

/// Parcels as they lie in memory: words of four bytes.
struct ParcelWords {
    float* words;  ///< of the first parcel
    int count;
};
inline constexpr int kWordsOfParcel = 12;
inline constexpr int kPositionWord = 0;  ///< x, y and z, in metres
inline constexpr int kShapeWord = 6;     ///< xx, yy, zz, xy, xz and yz

struct DeformationKernels {
    /// Deforms each parcel by the velocity's gradient in the cell that it lies in.
    void (*deform)(const DeformationView& view, const ParcelWords& parcels);

    static const DeformationKernels baseline, avx2, avx512;
};

}  // namespace pastoso::liquid

// Adding balls to layers of samples, compiled for every instruction set (pastoso_add_kernels). Lengths
// are in spacings of the lattice, from its first sample.
#pragma once

#include "core/kernels.hpp"

#include <cstddef>
#include <cstdint>

namespace pastoso::liquid {

/// One ball of a sum; the kernels say what its strength is.
struct Ball {
    float x, y, z;
    float reach;  ///< it adds nothing at this distance and beyond
    float strength;
};

/// Layers [first, end) of a lattice. Rows have room for seven more samples than nx.
struct BallSlab {
    float* values;  ///< of sample (0, 0, 0)
    std::ptrdiff_t stride_y, stride_z;
    int nx, ny, first, end;
    float least_square;  ///< squared distances are at least this
};

/// Adds balls[order[0]], balls[order[1]], ...
using AddBalls = void (*)(const BallSlab& slab, const Ball* balls, const std::uint32_t* order,
                          std::size_t count);

struct BallKernels {
    AddBalls compact;  ///< strength (1 - r^2/reach^2)^3
    /// strength (1/q - P(q)), q = r^2; P is the quintic Taylor polynomial at q = reach^2
    /// (far_field.hpp).
    AddBalls near_inverse_square;

    static const BallKernels baseline, avx2, avx512;
};

}  // namespace pastoso::liquid

// A multigrid level as the kernels see it: plain numbers and pointers.
#pragma once

#include <cstddef>

namespace pastoso::liquid {

/// Rows are cut into groups of this many cells of a colour: a register, or half of one.
inline constexpr int kGroup = 8;

/// Cells along each axis, and where a row's half of one colour stands. There is room for a group before
/// each row, and for a row and a slice all around; what lies there is 0.
struct LevelExtent {
    int nx = 0, ny = 0, nz = 0;

    int half() const { return (nx + 1) / 2; }
    std::ptrdiff_t stride_y() const { return (half() + kGroup - 1) / kGroup * kGroup + kGroup; }
    std::ptrdiff_t stride_z() const { return stride_y() * (ny + 2); }
    std::size_t sample_count() const { return static_cast<std::size_t>(stride_z() * (nz + 2) + kGroup); }
    std::ptrdiff_t index(int m, int j, int k) const {
        return kGroup + m + (j + 1) * stride_y() + (k + 1) * stride_z();
    }
    friend bool operator==(const LevelExtent&, const LevelExtent&) = default;
};

/// Whole groups: all numbers are multiples of kGroup. Within [plain_begin, plain_end), which lies in
/// [begin, end), all cells of both colours have the level's plain equation.
struct GroupRange {
    int begin, end;
    int plain_begin, plain_end;
};

/// What the equations of most cells have in common, far from walls: the same coefficient at all six
/// faces. Rows of them are worked on without reading coefficients, which are most of what a sweep reads.
struct PlainEquation {
    float coefficient = 0.0F, diagonal = 0.0F, inverse = 0.0F;
};

struct ColourPointers {
    float* colour[2];
};

struct LevelView {
    LevelExtent extent;
    std::ptrdiff_t stride_y, stride_z;
    ColourPointers west, south, below, diagonal, inverse, value, source;
    const GroupRange* rows;  ///< of row (j, k) at k ny + j
    PlainEquation plain;
};

/// The vectors of conjugate gradients besides a level's value z (the preconditioned residual) and source
/// r (the residual).
struct ConjugateView {
    ColourPointers solution, direction;
    ColourPointers image;  ///< the matrix times the direction
};

/// What turning the direction of conjugate gradients sums up.
struct DirectionSums {
    double product = 0.0;  ///< direction times image
    double image = 0.0;
    DirectionSums& operator+=(const DirectionSums& other) {
        product += other.product;
        image += other.image;
        return *this;
    }
};

}  // namespace pastoso::liquid

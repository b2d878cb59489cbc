// What the advection kernels are told: plain numbers and pointers.
#pragma once

#include <cstddef>

namespace pastoso::liquid {

enum class Interpolation {
    Linear,        ///< trilinear
    LimitedCubic,  ///< Catmull-Rom, clamped to the 8 nearest samples
    Cubic,         ///< Catmull-Rom as it is: overshoots at edges
};

/// What happens to a point that leaves the box.
enum class Edges { Walls, Periodic };

/// Velocity at cells' middles as centre_velocity() leaves it, and the box.
struct AdvectionView {
    const float* centres[3];                  ///< sample (0, 0, 0) of each component
    const float* ways[3];                     ///< the same of what trace_row() leaves
    bool ways_of_cells;                       ///< or of the samples that are advected
    std::ptrdiff_t stride_y, stride_z;        ///< in samples; the fields' too
    std::ptrdiff_t memory_begin, memory_end;  ///< what samples there are, from (0, 0, 0)
    float size_cells[3];
    float step;  ///< time step over cell size, in cells per m/s
    Edges edges;
};

/// Samples [begin, end) of a row, and where their ways go, in cells: the row's sample 0 along each axis.
struct TracedRow {
    int begin, end, j, k;
    int axis;  ///< as of an AdvectedRow
    float* way[3];
};

struct AdvectedField {
    const float* from;  ///< sample (0, 0, 0)
    float* to;          ///< the row's sample 0
};

inline constexpr int kMaxFieldsTogether = 4;

/// Samples [begin, end) of a row of fields that lie at the same places.
struct AdvectedRow {
    int begin, end, j, k;
    int axis;  ///< samples on the faces across this axis; 3: at cells' middles
    Interpolation interpolation;
    int field_count;
    AdvectedField fields[kMaxFieldsTogether];
};

/// Points of a group of samples or of carried points are worked on together.
inline constexpr int kPointsTogether = 8;

/// Places in cell units.
struct CarriedPoints {
    float* at[3];
};

/// A velocity on faces, sample (0, 0, 0) of each.
struct CarryView {
    const float* faces[3];
    std::ptrdiff_t stride_y, stride_z;
    float size_cells[3];
    float step;
    Edges edges;
    Interpolation interpolation;
};

}  // namespace pastoso::liquid

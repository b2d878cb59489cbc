// The loops of marching cubes over rows of samples, compiled for every instruction set
// (pastoso_add_kernels).
//
// Row (j, k) of samples is kept as one bit for each sample, 32 in a word, and one word more; bits beyond
// the row's end are 0. On the edges that begin in a row lie its vertices: those along x, along y, along
// z, each by ascending i.
#pragma once

#include "core/kernels.hpp"
#include "liquid/surface/cube_table.hpp"

#include <cstddef>
#include <cstdint>

namespace pastoso::liquid {

/// Bits of the rows (j, k), (j + 1, k), (j, k + 1), (j + 1, k + 1).
struct CellRowBits {
    const std::uint32_t* row[4];
    int nx;  ///< samples
};

/// The first vertices of a row of cells: along x in the four rows, along y in the rows at k and k + 1,
/// along z in the rows at j and j + 1.
struct CellRowVertices {
    std::uint32_t x[4], y[2], z[2];
};

/// The edges that begin in a row and run along one axis.
struct EdgeRow {
    const float* values;                 ///< sample (0, j, k)
    std::ptrdiff_t along;                ///< from there to the edge's other end
    std::ptrdiff_t low_y[2], high_y[2];  ///< from either end's row to the neighbours in y
    std::ptrdiff_t low_z[2], high_z[2];  ///< and in z; 0 where there is none
    float scale_y[2], scale_z[2];        ///< 1, or 2 where only one neighbour is there
    int axis, nx;
    float iso, spacing_m;
    float origin_m[3];  ///< of sample (0, j, k)
};

/// Seven rows of numbers.
struct VertexColumns {
    float* share;  ///< of the way to the edge's other end
    float* position[3];
    float* normal[3];
};

struct MarchingKernels {
    /// Bits of values > iso.
    void (*mark)(const float* values, int count, float iso, std::uint32_t* words);

    /// The bits where two rows differ, or a row from itself one sample on (`other` == `row`): their
    /// places. Returns how many.
    int (*compute_edges)(const std::uint32_t* row, const std::uint32_t* other, int nx,
                         std::int32_t* places);

    /// How many there are.
    std::uint32_t (*count_edges)(const std::uint32_t* row, const std::uint32_t* other, int nx);

    std::uint32_t (*count_triangles)(const CellRowBits& cells, const CubeCase* table);

    /// Vertices on the edges at these places.
    void (*place)(const EdgeRow& edges, const std::int32_t* places, int count, bool normals,
                  const VertexColumns& out);

    /// The triangles of a row of cells, three numbers each.
    void (*connect)(const CellRowBits& cells, const CellRowVertices& vertices, const CubeCase* table,
                    std::uint32_t* out);

    static const MarchingKernels baseline, avx2, avx512;
};

}  // namespace pastoso::liquid

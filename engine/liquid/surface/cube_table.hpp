// Which triangles separate the inner corners of a cube from the outer ones, for all 256 ways in which
// the corners can be inside.
#pragma once

#include <array>
#include <cstdint>

namespace pastoso::liquid {

/// Corner c lies at (c & 1, c >> 1 & 1, c >> 2). Edges 0 to 3 run along x from corners 0, 2, 4, 6, edges
/// 4 to 7 along y from corners 0, 1, 4, 5, edges 8 to 11 along z from corners 0, 1, 2, 3.
struct CubeCase {
    std::uint8_t triangle_count = 0;  ///< 0 to 5
    std::uint8_t edges[15] = {};      ///< three for each, counter-clockwise seen from outside
};

/// Bit c of the index says that corner c is inside. Made at the first call, by rule: on every face,
/// segments run around each run of inner corners, so that inner corners are kept apart where the face is
/// ambiguous; the rule looks at the face alone, and so neighbours agree. Segments chain into loops,
/// which are cut into triangles without diagonals that lie on a face of the cube, since a neighbour
/// might draw the same line.
const std::array<CubeCase, 256>& cube_table();

/// The two corners of an edge.
std::array<int, 2> cube_edge(int edge);

}  // namespace pastoso::liquid

#include "liquid/surface/cube_table.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace pastoso::liquid {
namespace {

constexpr int kEdges = 12, kMostTriangles = 5;
using Loop = std::vector<int>;  ///< of edges
using EdgeTriangle = std::array<int, 3>;

int edge_between(int a, int b) {
    for (int edge = 0; edge < kEdges; ++edge) {
        const auto [low, high] = cube_edge(edge);
        if ((low == a && high == b) || (low == b && high == a)) return edge;
    }
    PASTOSO_CHECK(false);
    return -1;
}

bool lie_on_one_face(int edge, int other) {
    for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) {
            const auto on_face = [&](int e) {
                const auto [low, high] = cube_edge(e);
                return (low >> axis & 1) == side && (high >> axis & 1) == side;
            };
            if (on_face(edge) && on_face(other)) return true;
        }
    }
    return false;
}

/// The corners of a face, counter-clockwise seen from outside.
std::array<int, 4> face_corners(int axis, int side) {
    const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, first = side << axis;
    if (side == 0) return {first, first | v, first | u | v, first | u};
    return {first, first | u, first | u | v, first | v};
}

bool is_inside(int corners_inside, int corner) {
    return (corners_inside >> corner & 1) != 0;
}

/// next[edge]: the edge at the other end of the segment that begins there, -1 for none.
std::array<int, kEdges> segments(int corners_inside) {
    std::array<int, kEdges> next;
    next.fill(-1);
    for (int face = 0; face < 6; ++face) {
        const std::array<int, 4> q = face_corners(face / 2, face % 2);
        const auto corner = [&](int i) { return q[static_cast<std::size_t>(i & 3)]; };
        for (int last = 0; last < 4; ++last) {
            if (!is_inside(corners_inside, corner(last)) || is_inside(corners_inside, corner(last + 1)))
                continue;
            int before = last;
            while (is_inside(corners_inside, corner(before)))
                --before;
            next[static_cast<std::size_t>(edge_between(corner(last), corner(last + 1)))] =
                edge_between(corner(before), corner(before + 1));
        }
    }
    return next;
}

std::vector<Loop> loops(std::array<int, kEdges> next) {
    std::vector<Loop> found;
    for (int first = 0; first < kEdges; ++first) {
        Loop loop;
        for (int edge = first; next[static_cast<std::size_t>(edge)] >= 0;) {
            loop.push_back(edge);
            edge = std::exchange(next[static_cast<std::size_t>(edge)], -1);
        }
        if (!loop.empty()) found.push_back(loop);
    }
    return found;
}

/// Cuts off one corner after the other, and tries the next one where a diagonal is forbidden.
bool triangulate(const Loop& loop, std::vector<EdgeTriangle>& triangles) {
    const std::size_t count = loop.size();
    if (count == 3) {
        triangles.push_back({loop[0], loop[2], loop[1]});
        return true;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const int before = loop[(i + count - 1) % count], after = loop[(i + 1) % count];
        if (lie_on_one_face(before, after)) continue;
        Loop rest = loop;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
        triangles.push_back({before, after, loop[i]});
        if (triangulate(rest, triangles)) return true;
        triangles.pop_back();
    }
    return false;
}

CubeCase make_case(int corners_inside) {
    std::vector<EdgeTriangle> triangles;
    for (const Loop& loop : loops(segments(corners_inside)))
        PASTOSO_CHECK(triangulate(loop, triangles));
    PASTOSO_CHECK_OP(triangles.size(), <=, static_cast<std::size_t>(kMostTriangles));
    CubeCase cube;
    cube.triangle_count = static_cast<std::uint8_t>(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t c = 0; c < 3; ++c)
            cube.edges[3 * t + c] = static_cast<std::uint8_t>(triangles[t][c]);
    return cube;
}

std::array<CubeCase, 256> make_table() {
    std::array<CubeCase, 256> table;
    for (int corners_inside = 0; corners_inside < 256; ++corners_inside)
        table[static_cast<std::size_t>(corners_inside)] = make_case(corners_inside);
    return table;
}

}  // namespace

std::array<int, 2> cube_edge(int edge) {
    constexpr std::array<int, kEdges> kLow = {0, 2, 4, 6, 0, 1, 4, 5, 0, 1, 2, 3};
    const int low = kLow[static_cast<std::size_t>(edge)];
    return {low, low | 1 << edge / 4};
}

const std::array<CubeCase, 256>& cube_table() {
    static const std::array<CubeCase, 256> table = make_table();
    return table;
}

}  // namespace pastoso::liquid

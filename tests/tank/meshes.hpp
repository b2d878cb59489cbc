// Closed meshes whose shape is known.
#pragma once

#include "liquid/surface/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

namespace pastoso::tank::test {

using liquid::TriangleMesh;

/// The block from `low` to `high`, of twelve triangles.
inline TriangleMesh block_mesh(const glm::vec3& low, const glm::vec3& high) {
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.positions_m.emplace_back((corner & 1) != 0 ? high.x : low.x,
                                      (corner & 2) != 0 ? high.y : low.y,
                                      (corner & 4) != 0 ? high.z : low.z);
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

inline TriangleMesh octahedron() {
    return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
            {},
            {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

/// Each triangle in four, with vertices on the unit sphere.
inline TriangleMesh finer(const TriangleMesh& coarse) {
    TriangleMesh mesh;
    mesh.positions_m = coarse.positions_m;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [found, is_new] =
            middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.positions_m.size()));
        if (is_new)
            mesh.positions_m.push_back(glm::normalize(mesh.positions_m[a] + mesh.positions_m[b]));
        return found->second;
    };
    for (const auto& [a, b, c] : coarse.triangles) {
        const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        mesh.triangles.insert(mesh.triangles.end(),
                              {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    return mesh;
}

/// 8 * 4^levels triangles with vertices on the sphere.
inline TriangleMesh sphere_mesh(const glm::vec3& centre, float radius, int levels) {
    TriangleMesh mesh = octahedron();
    for (int level = 0; level < levels; ++level)
        mesh = finer(mesh);
    for (glm::vec3& position : mesh.positions_m)
        position = centre + radius * position;
    return mesh;
}

/// Around the z axis, of n x n quadrilaterals.
inline TriangleMesh torus_mesh(float ring_radius, float tube_radius, std::uint32_t n) {
    TriangleMesh mesh;
    const float turn = 2.0F * std::numbers::pi_v<float> / static_cast<float>(n);
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < n; ++j) {
            const float around = turn * static_cast<float>(i), across = turn * static_cast<float>(j);
            const float radius = ring_radius + tube_radius * std::cos(across);
            mesh.positions_m.emplace_back(radius * std::cos(around), radius * std::sin(around),
                                          tube_radius * std::sin(across));
            const std::uint32_t next_i = (i + 1) % n, next_j = (j + 1) % n;
            const std::uint32_t a = i * n + j, b = next_i * n + j, c = next_i * n + next_j,
                                d = i * n + next_j;
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
        }
    return mesh;
}

/// Both in one mesh.
inline TriangleMesh joined(TriangleMesh mesh, const TriangleMesh& other) {
    const auto first = static_cast<std::uint32_t>(mesh.positions_m.size());
    mesh.positions_m.insert(mesh.positions_m.end(), other.positions_m.begin(), other.positions_m.end());
    for (const auto& [a, b, c] : other.triangles)
        mesh.triangles.push_back({first + a, first + b, first + c});
    return mesh;
}

inline TriangleMesh inside_out(TriangleMesh mesh) {
    for (auto& triangle : mesh.triangles)
        std::swap(triangle[1], triangle[2]);
    return mesh;
}

/// Along one axis, with the triangles turned so that outside stays outside.
inline TriangleMesh mirrored(TriangleMesh mesh, int axis) {
    for (glm::vec3& position : mesh.positions_m)
        position[axis] = -position[axis];
    return inside_out(std::move(mesh));
}

}  // namespace pastoso::tank::test

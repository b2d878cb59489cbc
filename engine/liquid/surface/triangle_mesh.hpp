// A surface of triangles with shared vertices, in metres, z up.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace pastoso::liquid {

struct TriangleMesh {
    std::vector<glm::vec3> positions_m;
    std::vector<glm::vec3> normals;  ///< unit vectors that point outwards, one for each vertex; or none
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise seen from outside

    bool empty() const { return triangles.empty(); }
    friend bool operator==(const TriangleMesh&, const TriangleMesh&) = default;
};

/// What a closed mesh encloses, in m3: the sum of a . (b x c) / 6 over its triangles.
double volume_m3(const TriangleMesh& mesh);

}  // namespace pastoso::liquid

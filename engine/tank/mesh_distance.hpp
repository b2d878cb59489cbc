// The distance from a closed mesh, and on which side of it a point lies.
//
// How far: a tree of boxes, the nearer box first, and those left out that are farther away than what was
// found. Which side: the winding number, counted by the triangles above the point, each +1 or -1 as it
// looks up or down. Pseudonormals at the nearest point would come for less, but they need every triangle
// to have an area, every corner to be a disc and bodies of one mesh not to overlap, and files from
// elsewhere do not keep to that; solid angles would be summed over all triangles. Whether a triangle
// lies above is decided edge by edge, by the same arithmetic for both triangles of an edge, so that no
// point slips between two triangles or meets both: the count is exact for every closed mesh.
#pragma once

#include "liquid/surface/triangle_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace pastoso::tank {

class MeshDistance {
  public:
    /// A mesh that check_closed() (closed_mesh.hpp) accepts; it is copied.
    explicit MeshDistance(const liquid::TriangleMesh& mesh);

    /// Negative where the mesh winds around the point, whichever way round. A distance of `reach` or
    /// more is given as the reach, with its sign. Threads may ask at the same time.
    float operator()(const glm::vec3& point, float reach = std::numeric_limits<float>::infinity()) const;

  private:
    struct Corners {
        glm::vec3 a, b, c;
    };
    struct Node {
        glm::vec3 low, high;
        std::uint32_t next;  ///< a leaf's first triangle; of others, the second child: the first follows
        std::uint32_t count;  ///< triangles of a leaf, 0 of others
    };

    void build(std::span<Corners> triangles, std::size_t first);
    float nearest2(const glm::vec3& point, float most2) const;
    int winding(const glm::vec3& point) const;

    std::vector<Corners> triangles_;  ///< in the order of the leaves
    std::vector<Node> nodes_;         ///< a parent before its children
};

}  // namespace pastoso::tank

#include "liquid/surface/triangle_mesh.hpp"

#include <glm/geometric.hpp>

namespace pastoso::liquid {

double volume_m3(const TriangleMesh& mesh) {
    double sum = 0.0;
    for (const auto& [first, second, third] : mesh.triangles) {
        const glm::dvec3 a(mesh.positions_m[first]), b(mesh.positions_m[second]),
            c(mesh.positions_m[third]);
        sum += glm::dot(a, glm::cross(b, c));
    }
    return sum / 6.0;
}

}  // namespace pastoso::liquid

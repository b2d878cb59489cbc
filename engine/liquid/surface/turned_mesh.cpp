#include "liquid/surface/turned_mesh.hpp"

#include "core/check.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace pastoso::liquid {
namespace {

/// Joins two rings of vertices. At the axis one of two triangles has no area.
void add_band(std::uint32_t from, std::uint32_t to, std::uint32_t segments, bool from_axis, bool to_axis,
              TriangleMesh& mesh) {
    for (std::uint32_t s = 0; s < segments; ++s) {
        const std::uint32_t next = (s + 1) % segments;
        if (!from_axis) mesh.triangles.push_back({from + s, from + next, to + s});
        if (!to_axis) mesh.triangles.push_back({to + s, from + next, to + next});
    }
}

}  // namespace

void add_turned(const glm::vec2& axis_m, std::span<const TurnedPoint> profile, int segments,
                TriangleMesh& mesh) {
    PASTOSO_CHECK_OP(segments, >=, 3);
    const auto first = static_cast<std::uint32_t>(mesh.positions_m.size());
    const auto around = static_cast<std::uint32_t>(segments);
    for (const TurnedPoint& point : profile)
        for (int s = 0; s < segments; ++s) {
            const double angle = 2.0 * std::numbers::pi * s / segments;
            const glm::vec2 out(static_cast<float>(std::cos(angle)),
                                static_cast<float>(std::sin(angle)));
            mesh.positions_m.emplace_back(axis_m + point.radius_m * out, point.z_m);
            mesh.normals.emplace_back(point.normal.x * out, point.normal.y);
        }
    for (std::uint32_t n = 0; n + 1 < profile.size(); ++n)
        add_band(first + n * around, first + (n + 1) * around, around, profile[n].radius_m == 0.0F,
                 profile[n + 1].radius_m == 0.0F, mesh);
}

}  // namespace pastoso::liquid

#include "liquid/tea/cup_mesh.hpp"

#include "core/check.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

#include <glm/geometric.hpp>

namespace pastoso::liquid {
namespace {

/// A point of a profile that turns around the axis.
struct Point {
    float radius_m, z_m;
};

/// Adds what a straight piece of the profile sweeps over. Going from `from` to `to`, its outside lies on
/// the right hand, where the radius points to the right and z up.
void sweep(const Cup& cup, const Point& from, const Point& to, int segments, TriangleMesh& mesh) {
    const auto first = static_cast<std::uint32_t>(mesh.positions_m.size());
    const glm::vec2 along = glm::normalize(glm::vec2(to.radius_m - from.radius_m, to.z_m - from.z_m));
    for (int s = 0; s < segments; ++s) {
        const double angle = 2.0 * std::numbers::pi * s / segments;
        const auto cosine = static_cast<float>(std::cos(angle)),
                   sine = static_cast<float>(std::sin(angle));
        for (const Point& point : {from, to}) {
            mesh.positions_m.push_back({cup.axis_m.x + point.radius_m * cosine,
                                        cup.axis_m.y + point.radius_m * sine, point.z_m});
            mesh.normals.push_back({along.y * cosine, along.y * sine, -along.x});
        }
    }
    for (int s = 0; s < segments; ++s) {
        const std::uint32_t low = first + 2 * static_cast<std::uint32_t>(s);
        const std::uint32_t next = first + 2 * static_cast<std::uint32_t>((s + 1) % segments);
        // At the axis one of the two has no area.
        if (from.radius_m > 0.0F) mesh.triangles.push_back({low, next, low + 1});
        if (to.radius_m > 0.0F) mesh.triangles.push_back({low + 1, next, next + 1});
    }
}

}  // namespace

CupMeshes cup_meshes(const Cup& cup, int segments) {
    PASTOSO_CHECK_OP(segments, >=, 3);
    PASTOSO_CHECK(cup.foot_m < cup.floor_m && cup.floor_m < cup.level_m && cup.level_m < cup.rim_m);
    const auto inner = [&](float z_m) { return Point{cup.inner_radius_m(z_m), z_m}; };
    const auto outer = [&](float z_m) { return Point{cup.inner_radius_m(z_m) + cup.wall_m, z_m}; };
    const Point foot_middle{0.0F, cup.foot_m}, floor_middle{0.0F, cup.floor_m},
        level_middle{0.0F, cup.level_m};
    CupMeshes meshes;
    sweep(cup, foot_middle, outer(cup.foot_m), segments, meshes.glass_air);
    sweep(cup, outer(cup.foot_m), outer(cup.rim_m), segments, meshes.glass_air);
    sweep(cup, outer(cup.rim_m), inner(cup.rim_m), segments, meshes.glass_air);
    sweep(cup, inner(cup.rim_m), inner(cup.level_m), segments, meshes.glass_air);
    sweep(cup, floor_middle, inner(cup.floor_m), segments, meshes.tea_glass);
    sweep(cup, inner(cup.floor_m), inner(cup.level_m), segments, meshes.tea_glass);
    sweep(cup, inner(cup.level_m), level_middle, segments, meshes.tea_air);
    return meshes;
}

}  // namespace pastoso::liquid

#include "liquid/vessel/cup_mesh.hpp"

#include "core/check.hpp"
#include "liquid/surface/turned_mesh.hpp"

#include <array>

#include <glm/geometric.hpp>

namespace pastoso::liquid {
namespace {

/// A point of a profile that turns around the axis.
struct Point {
    float radius_m, z_m;
};

/// Adds what a straight piece of the profile sweeps over (turned_mesh.hpp).
void sweep(const Cup& cup, const Point& from, const Point& to, int segments, TriangleMesh& mesh) {
    const glm::vec2 along = glm::normalize(glm::vec2(to.radius_m - from.radius_m, to.z_m - from.z_m));
    const glm::vec2 normal(along.y, -along.x);
    const std::array<TurnedPoint, 2> profile = {
        {{from.radius_m, from.z_m, normal}, {to.radius_m, to.z_m, normal}}};
    add_turned(cup.axis_m, profile, segments, mesh);
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

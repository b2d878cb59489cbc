#include "tank/shape.hpp"

#include "core/error.hpp"
#include "core/value_range.hpp"
#include "tank/closed_mesh.hpp"

#include <glm/geometric.hpp>

namespace pastoso::tank {
namespace {

constexpr double kMostScale = 1e6;

void check_size(const std::string& name, float size_m) {
    core::check_range(name, static_cast<double>(size_m), kSmallest_m, kFarthest_m);
}

void check_place(const std::string& name, const glm::vec3& place_m) {
    for (const int axis : {0, 1, 2})
        core::check_range(name, static_cast<double>(place_m[axis]), -kFarthest_m, kFarthest_m);
}

void check_form(const Sphere& sphere) {
    check_place("sphere: centre_m", sphere.centre_m);
    check_size("sphere: radius_m", sphere.radius_m);
}

void check_form(const Block& block) {
    check_place("block: low_m", block.low_m);
    check_place("block: high_m", block.high_m);
    for (const int axis : {0, 1, 2})
        check_size("block: high_m - low_m", block.high_m[axis] - block.low_m[axis]);
}

void check_form(const Cylinder& cylinder) {
    check_place("cylinder: from_m", cylinder.from_m);
    check_place("cylinder: to_m", cylinder.to_m);
    // Twice as far as a place is from the middle, along three axes.
    core::check_range("cylinder: the distance from from_m to to_m",
                      static_cast<double>(glm::distance(cylinder.from_m, cylinder.to_m)), kSmallest_m,
                      4.0 * kFarthest_m);
    check_size("cylinder: radius_m", cylinder.radius_m);
}

void check_form(const Torus& torus) {
    check_place("torus: centre_m", torus.centre_m);
    check_place("torus: axis", torus.axis);
    core::check_range("torus: the length of axis", static_cast<double>(glm::length(torus.axis)),
                      kSmallest_m, 2.0 * kFarthest_m);
    check_size("torus: ring_radius_m", torus.ring_radius_m);
    check_size("torus: tube_radius_m", torus.tube_radius_m);
    check_size("torus: ring_radius_m - tube_radius_m", torus.ring_radius_m - torus.tube_radius_m);
}

/// The level is that of what is in the cup: it says nothing about the glass, but is a number.
void check_form(const CupGlass& glass) {
    const liquid::Cup& cup = glass.cup;
    check_place("cup: x_m and y_m", glm::vec3(cup.axis_m, 0.0F));
    check_place("cup: foot_m, floor_m and rim_m", {cup.foot_m, cup.floor_m, cup.rim_m});
    check_size("cup: floor_m - foot_m", cup.floor_m - cup.foot_m);
    check_size("cup: rim_m - floor_m", cup.rim_m - cup.floor_m);
    core::check_range("cup: level_m", static_cast<double>(cup.level_m), -kFarthest_m, kFarthest_m);
    core::check_range("cup: slope", static_cast<double>(cup.slope), -10.0, 10.0);
    check_size("cup: wall_m", cup.wall_m);
    check_size("cup: floor_radius_m", cup.floor_radius_m);
    check_size("cup: the inner radius at rim_m", cup.inner_radius_m(cup.rim_m));
    check_size("cup: the outer radius at foot_m", cup.inner_radius_m(cup.foot_m) + cup.wall_m);
}

void check_form(const MeshBody& body) {
    if (!body.mesh) throw core::InputError("mesh: \"%1\" was not read.", body.file);
    check_place("mesh: position_m", body.position_m);
    core::check_range("mesh: scale", static_cast<double>(body.scale), 1.0 / kMostScale, kMostScale);
    check_closed(*body.mesh);
}

void check_form(const Combined& combined) {
    if (combined.parts.empty()) throw core::InputError("a combination has no parts.");
    for (const Shape& part : combined.parts)
        check_shape(part);
}

}  // namespace

void check_shape(const Shape& shape) {
    std::visit([](const auto& form) { check_form(form); }, shape.form);
}

}  // namespace pastoso::tank

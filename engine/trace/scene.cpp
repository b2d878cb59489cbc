#include "trace/scene.hpp"

#include "core/error.hpp"

#include <cmath>
#include <sstream>
#include <string>
#include <string_view>

#include <glm/geometric.hpp>

namespace pastoso::trace {
namespace {

constexpr float kFarthest_m = 1e3F;

[[noreturn]] void refuse(std::string_view name, float value, std::string_view range) {
    std::ostringstream text;
    text << "scene: " << name << " is " << value << ", but must be " << range << ".";
    throw core::InputError(text.str());
}

/// NaN lies in no range.
void check(std::string_view name, float value, float low, float high) {
    if (value >= low && value <= high) return;
    std::ostringstream range;
    range << "from " << low << " to " << high;
    refuse(name, value, range.str());
}

void check(std::string_view name, const glm::vec3& value, float low, float high) {
    for (int axis = 0; axis < 3; ++axis)
        check(name, value[axis], low, high);
}

void check_place(std::string_view name, const glm::vec3& place) {
    check(name, place, -kFarthest_m, kFarthest_m);
}

void check_direction(std::string_view name, const glm::vec3& direction) {
    check_place(name, direction);
    if (glm::length(direction) < 1e-6F) refuse(name, 0.0F, "a direction");
}

void check_cup(const liquid::Cup& cup) {
    check_place("cup axis", {cup.axis_m, 0.0F});
    check("cup slope", cup.slope, -2.0F, 2.0F);
    check("cup floor", cup.floor_m, -kFarthest_m, kFarthest_m);
    check("cup level", cup.level_m, std::nextafter(cup.floor_m, kFarthest_m), kFarthest_m);
    check("cup rim", cup.rim_m, cup.level_m, kFarthest_m);
    check("cup foot", cup.foot_m, -kFarthest_m, cup.floor_m);
    check("cup wall", cup.wall_m, 1e-5F, 1.0F);
    check("cup radius at the foot", cup.inner_radius_m(cup.foot_m), 1e-4F, 10.0F);
    check("cup radius at the rim", cup.inner_radius_m(cup.rim_m), 1e-4F, 10.0F);
}

void check_dent(const LevelDent& dent) {
    check_place("dent", {dent.at_m, 0.0F});
    check("dent radius", dent.radius_m, 1e-6F, kFarthest_m);
    check("dent depth", dent.depth_m, 0.0F, dent.radius_m);
}

void check_tank(const Tank& tank) {
    check_place("tank inner_low", tank.inner_low_m);
    for (int axis = 0; axis < 3; ++axis)
        check("tank inner_high", tank.inner_high_m[axis], tank.inner_low_m[axis] + 1e-4F, kFarthest_m);
    check("tank wall", tank.wall_m, 1e-5F, 1.0F);
}

void check_mesh(const std::string& name, const liquid::TriangleMesh& mesh) {
    for (const glm::vec3& position : mesh.positions_m)
        check_place(name + " position", position);
    if (!mesh.normals.empty() && mesh.normals.size() != mesh.positions_m.size())
        refuse(name + "'s number of normals", static_cast<float>(mesh.normals.size()),
               "0 or that of its positions");
    for (const glm::vec3& normal : mesh.normals)
        check(name + " normal", normal, -2.0F, 2.0F);
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle)
            if (corner >= mesh.positions_m.size())
                refuse(name + "'s corner", static_cast<float>(corner), "the number of a position");
}

void check_milk_share(const grid::BlockField& field) {
    if (field.empty()) return;
    check("milk share's cell", field.shape().cell_m, 1e-6F, 10.0F);
    for (const float value : field.samples())
        check("milk share", value, -1e6F, 1e6F);
}

void check_optics(const Optics& optics) {
    check("tea_absorption", optics.tea_absorption_per_m, 0.0F, 1e6F);
    check("glass_absorption", optics.glass_absorption_per_m, 0.0F, 1e6F);
    check("milk_scattering", optics.milk_scattering_per_m, 1e-3F, 1e6F);
    check("milk_albedo", optics.milk_albedo, 0.0F, 1.0F);
    check("milk_reflectance", optics.milk_reflectance, 0.0F, 1.0F);
    check("solid_reflectance", optics.solid_reflectance, 0.0F, 1.0F);
    check("glass_ior", optics.glass_ior, 1.0F, 4.0F);
    check("liquid_ior", optics.liquid_ior, 1.0F, 4.0F);
}

void check_camera(const Camera& camera) {
    check_place("camera eye", camera.eye_m);
    check_place("camera target", camera.target_m);
    check("distance from eye to target", glm::distance(camera.eye_m, camera.target_m), 1e-4F,
          4.0F * kFarthest_m);
    check("field_of_view", camera.field_of_view_deg, 1.0F, 120.0F);
    check("lens_radius", camera.lens_radius_m, 0.0F, 1.0F);
}

void check_light(const Scene& scene) {
    check("sky below", scene.sky.below, 0.0F, 1e6F);
    check("sky above", scene.sky.above, 0.0F, 1e6F);
    check("window radiance", scene.sky.window_radiance, 0.0F, 1e6F);
    check("window radius", scene.sky.window_radius_deg, 0.1F, 80.0F);
    check_direction("window_towards", scene.sky.window_towards);
    if (!scene.lamp) return;
    check_direction("lamp towards", scene.lamp->towards);
    check("lamp radius", scene.lamp->radius_deg, 0.1F, 80.0F);
    check("lamp radiance", scene.lamp->radiance, 0.0F, 1e6F);
}

void check_table(const Table& table) {
    check("table height", table.height_m, -kFarthest_m, kFarthest_m);
    check("table radius", table.radius_m, 1e-4F, kFarthest_m);
    check("table reflectance", table.reflectance, 0.0F, 1.0F);
    check("table fading", table.fading_per_m2, 0.0F, 1e6F);
    check("table fading_to", table.fading_to, 0.0F, 1.0F);
}

}  // namespace

void check_scene(const Scene& scene) {
    if (scene.cup) check_cup(*scene.cup);
    for (const LevelDent& dent : scene.dents)
        check_dent(dent);
    if (scene.tank) check_tank(*scene.tank);
    check_mesh("milk", scene.milk);
    check_mesh("clear_liquid", scene.clear_liquid);
    check_mesh("solids", scene.solids);
    check_milk_share(scene.milk_share);
    check_optics(scene.optics);
    check_camera(scene.camera);
    check_light(scene);
    if (scene.table) check_table(*scene.table);
}

}  // namespace pastoso::trace

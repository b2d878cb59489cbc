#include "trace/scene.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"

#include <cmath>
#include <string>

#include <glm/geometric.hpp>

namespace pastoso::trace {
namespace {

constexpr float kFarthest_m = 1e3F;

std::string text_of(float value) {
    return core::number_text(static_cast<double>(value), 6);
}

/// NaN lies in no range.
void check(const core::Message& name, float value, float low, float high) {
    if (value >= low && value <= high) return;
    throw core::InputError("scene: %1 is %2, but must be from %3 to %4.", name, text_of(value),
                           text_of(low), text_of(high));
}

void check(const core::Message& name, const glm::vec3& value, float low, float high) {
    for (int axis = 0; axis < 3; ++axis)
        check(name, value[axis], low, high);
}

void check_place(const core::Message& name, const glm::vec3& place) {
    check(name, place, -kFarthest_m, kFarthest_m);
}

void check_direction(const core::Message& name, const glm::vec3& direction) {
    check_place(name, direction);
    if (glm::length(direction) < 1e-6F)
        throw core::InputError("scene: %1 is 0, but must be a direction.", name);
}

void check_cup(const liquid::Cup& cup) {
    check_place(core::message("cup axis"), {cup.axis_m, 0.0F});
    check(core::message("cup slope"), cup.slope, -2.0F, 2.0F);
    check(core::message("cup floor"), cup.floor_m, -kFarthest_m, kFarthest_m);
    check(core::message("cup level"), cup.level_m, std::nextafter(cup.floor_m, kFarthest_m),
          kFarthest_m);
    check(core::message("cup rim"), cup.rim_m, cup.level_m, kFarthest_m);
    check(core::message("cup foot"), cup.foot_m, -kFarthest_m, cup.floor_m);
    check(core::message("cup wall"), cup.wall_m, 1e-5F, 1.0F);
    check(core::message("cup radius at the foot"), cup.inner_radius_m(cup.foot_m), 1e-4F, 10.0F);
    check(core::message("cup radius at the rim"), cup.inner_radius_m(cup.rim_m), 1e-4F, 10.0F);
}

void check_dent(const LevelDent& dent) {
    check_place(core::message("dent"), {dent.at_m, 0.0F});
    check(core::message("dent radius"), dent.radius_m, 1e-6F, kFarthest_m);
    check(core::message("dent depth"), dent.depth_m, 0.0F, dent.radius_m);
}

void check_tank(const Tank& tank) {
    check_place(core::Message::verbatim("tank inner_low"), tank.inner_low_m);
    for (int axis = 0; axis < 3; ++axis)
        check(core::Message::verbatim("tank inner_high"), tank.inner_high_m[axis],
              tank.inner_low_m[axis] + 1e-4F, kFarthest_m);
    check(core::message("tank wall"), tank.wall_m, 1e-5F, 1.0F);
}

void check_mesh(const char* name, const liquid::TriangleMesh& mesh) {
    const core::Message position_name = core::message("%1 position", name);
    for (const glm::vec3& position : mesh.positions_m)
        check_place(position_name, position);
    if (!mesh.normals.empty() && mesh.normals.size() != mesh.positions_m.size())
        throw core::InputError(
            "scene: %1's number of normals is %2, but must be 0 or that of its positions.", name,
            text_of(static_cast<float>(mesh.normals.size())));
    const core::Message normal_name = core::message("%1 normal", name);
    for (const glm::vec3& normal : mesh.normals)
        check(normal_name, normal, -2.0F, 2.0F);
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle)
            if (corner >= mesh.positions_m.size())
                throw core::InputError("scene: %1's corner is %2, but must be the number of a position.",
                                       name, text_of(static_cast<float>(corner)));
}

void check_milk_share(const grid::BlockField& field) {
    if (field.empty()) return;
    check(core::message("milk share's cell"), field.shape().cell_m, 1e-6F, 10.0F);
    const core::Message name = core::message("milk share");
    for (const float value : field.samples())
        check(name, value, -1e6F, 1e6F);
}

void check_optics(const Optics& optics) {
    check(core::Message::verbatim("tea_absorption"), optics.tea_absorption_per_m, 0.0F, 1e6F);
    check(core::Message::verbatim("glass_absorption"), optics.glass_absorption_per_m, 0.0F, 1e6F);
    check(core::Message::verbatim("milk_scattering"), optics.milk_scattering_per_m, 1e-3F, 1e6F);
    check(core::Message::verbatim("milk_albedo"), optics.milk_albedo, 0.0F, 1.0F);
    check(core::Message::verbatim("milk_reflectance"), optics.milk_reflectance, 0.0F, 1.0F);
    check(core::Message::verbatim("solid_reflectance"), optics.solid_reflectance, 0.0F, 1.0F);
    check(core::Message::verbatim("glass_ior"), optics.glass_ior, 1.0F, 4.0F);
    check(core::Message::verbatim("liquid_ior"), optics.liquid_ior, 1.0F, 4.0F);
}

void check_camera(const Camera& camera) {
    check_place(core::message("camera eye"), camera.eye_m);
    check_place(core::message("camera target"), camera.target_m);
    check(core::message("distance from eye to target"), glm::distance(camera.eye_m, camera.target_m),
          1e-4F, 4.0F * kFarthest_m);
    check(core::Message::verbatim("field_of_view"), camera.field_of_view_deg, 1.0F, 120.0F);
    check(core::Message::verbatim("lens_radius"), camera.lens_radius_m, 0.0F, 1.0F);
}

void check_light(const Scene& scene) {
    check(core::message("sky below"), scene.sky.below, 0.0F, 1e6F);
    check(core::message("sky above"), scene.sky.above, 0.0F, 1e6F);
    check(core::message("window radiance"), scene.sky.window_radiance, 0.0F, 1e6F);
    check(core::message("window radius"), scene.sky.window_radius_deg, 0.1F, 80.0F);
    check_direction(core::Message::verbatim("window_towards"), scene.sky.window_towards);
    if (!scene.lamp) return;
    check_direction(core::message("lamp towards"), scene.lamp->towards);
    check(core::message("lamp radius"), scene.lamp->radius_deg, 0.1F, 80.0F);
    check(core::message("lamp radiance"), scene.lamp->radiance, 0.0F, 1e6F);
}

void check_table(const Table& table) {
    check(core::message("table height"), table.height_m, -kFarthest_m, kFarthest_m);
    check(core::message("table radius"), table.radius_m, 1e-4F, kFarthest_m);
    check(core::message("table reflectance"), table.reflectance, 0.0F, 1.0F);
    check(core::message("table fading"), table.fading_per_m2, 0.0F, 1e6F);
    check(core::Message::verbatim("table fading_to"), table.fading_to, 0.0F, 1.0F);
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

#include "trace/tank_scene.hpp"

#include "core/check.hpp"
#include "trace/numbers.hpp"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>

namespace pastoso::trace {
namespace {

/// Plates are this share of the box's longest side, but no thinner than what reaches into them.
constexpr float kWallShare = 0.013F;
constexpr float kLeastWall_cells = 0.5F;
/// What the liquid absorbs along the box's longest side.
constexpr glm::vec3 kAbsorption(1.35F, 0.33F, 0.135F);

/// From the middle of the tank to the eye; any length.
const glm::vec3 kTowardsEye(0.42F, -1.0F, 0.42F);
/// The picture's edges are so much farther from its middle than the tank's corners.
constexpr float kMargin = 1.06F;

glm::vec3 size_of(const grid::BoxShape& box) {
    return glm::vec3(box.nx, box.ny, box.nz) * box.cell_m;
}

void scale(liquid::TriangleMesh& mesh, float factor) {
    for (glm::vec3& position : mesh.positions_m)
        position *= factor;
}

/// The distance from which a point off the target, in the camera's frame (right, up, forward), is within
/// the picture.
float distance_for(const glm::vec3& point, float half_height, float aspect) {
    return std::max(std::abs(point.y) / half_height, std::abs(point.x) / (half_height * aspect)) -
           point.z;
}

Camera camera_for(const Tank& tank, float aspect) {
    Camera camera;
    camera.field_of_view_deg = 22.0F;
    camera.lens_radius_m = 0.001F;
    const glm::vec3 low = tank.inner_low_m - tank.wall_m, high = tank.inner_high_m + tank.wall_m;
    camera.target_m = 0.5F * (low + high);
    const glm::vec3 forward = -glm::normalize(kTowardsEye);
    const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0.0F, 0.0F, 1.0F)));
    const glm::vec3 up = glm::cross(right, forward);
    const glm::vec2 half = cos_sin_of_turns(camera.field_of_view_deg / 720.0F);
    float away_m = 0.0F;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 off =
            glm::vec3((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                      (corner & 4) != 0 ? high.z : low.z) -
            camera.target_m;
        const glm::vec3 seen(kMargin * glm::dot(off, right), kMargin * glm::dot(off, up),
                             glm::dot(off, forward));
        away_m = std::max(away_m, distance_for(seen, half.y / half.x, aspect));
    }
    camera.eye_m = camera.target_m - forward * away_m;
    return camera;
}

}  // namespace

float tank_wall_m(const grid::BoxShape& box) {
    return std::max(kWallShare * largest(size_of(box)), kLeastWall_cells * box.cell_m);
}

glm::vec3 tank_absorption_per_m(const grid::BoxShape& box) {
    return kAbsorption / largest(size_of(box));
}

float tank_model_scale(const grid::BoxShape& box) {
    return kTankModel_m / largest(size_of(box));
}

Scene tank_scene(const grid::BoxField& milk, liquid::TriangleMesh liquid, liquid::TriangleMesh solids,
                 float aspect) {
    PASTOSO_CHECK_OP(aspect, >, 0.0F);
    const grid::BoxShape& box = milk.shape();
    const float model = tank_model_scale(box);
    Scene scene;
    scene.cup.reset();
    scene.clear_liquid = std::move(liquid);
    scene.solids = std::move(solids);
    scale(scene.clear_liquid, model);
    scale(scene.solids, model);
    grid::BoxField share({box.nx, box.ny, box.nz, box.cell_m * model});
    share.values() = milk.values();
    scene.milk_share = grid::BlockField(share);
    Tank tank;
    tank.inner_low_m = glm::vec3(0.0F);
    tank.inner_high_m = size_of(box) * model;
    tank.wall_m = tank_wall_m(box) * model;
    scene.tank = tank;
    scene.optics.tea_absorption_per_m = tank_absorption_per_m(box) / model;
    scene.optics.milk_scattering_per_m = 1200.0F;
    scene.table->height_m = -tank.wall_m;
    scene.table->radius_m = 4.0F;
    scene.table->fading_per_m2 = 2.0F;
    scene.camera = camera_for(tank, aspect);
    return scene;
}

}  // namespace pastoso::trace

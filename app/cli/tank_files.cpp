#include "cli/tank_files.hpp"

#include "cli/stopwatch.hpp"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pastoso::cli {
namespace {

/// Points of the surface's lattice along a cell.
constexpr int kParts = 2;
/// The longest side's worth of liquid lets this much of the light's colours by, as natural exponents.
constexpr glm::vec3 kTint = {0.3F, 0.08F, 0.04F};
/// How thick the glass is, against the longest side; how far the liquid reaches into it, in cells.
constexpr float kGlassShare = 0.02F, kReach_cells = 0.25F;

/// The usual light around a tank on a table, seen from the usual side, from as far as its size asks for.
trace::Scene scene_around(const glm::vec3& size_m) {
    trace::Scene scene;
    const trace::Camera usual = scene.camera;
    const float longest_m = std::max({size_m.x, size_m.y, size_m.z}), usual_m = 0.1F;
    const float scale = longest_m / usual_m;
    scene.cup.reset();
    scene.tank = trace::Tank{glm::vec3(0.0F), size_m, kGlassShare * longest_m};
    scene.optics.tea_absorption_per_m = kTint / longest_m;
    scene.optics.glass_absorption_per_m /= scale;
    scene.camera.target_m = 0.5F * size_m - glm::vec3(0.0F, 0.0F, 0.05F * longest_m);
    scene.camera.eye_m = scene.camera.target_m + 1.25F * scale * (usual.eye_m - usual.target_m);
    scene.camera.lens_radius_m = usual.lens_radius_m * scale;
    scene.table->height_m = -kGlassShare * longest_m;
    scene.table->radius_m *= scale;
    scene.table->fading_per_m2 /= scale * scale;
    return scene;
}

/// The share of liquid at the middles of cells, soft over a cell.
grid::BoxField density_of(const tank::TankFrame& frame) {
    grid::BoxField density(frame.milk.shape());
    const grid::BoxShape& box = density.shape();
    for (int k = 0; k < box.nz; ++k)
        for (int j = 0; j < box.ny; ++j)
            for (int i = 0; i < box.nx; ++i) {
                float sum_m = 0.0F;  // of the samples around the middle
                for (int corner = 0; corner < 8; ++corner)
                    sum_m += frame.level_m.at(kParts * (i + 1) + (corner & 1),
                                              kParts * (j + 1) + (corner >> 1 & 1),
                                              kParts * (k + 1) + (corner >> 2));
                density.at(i, j, k) = glm::clamp(0.5F - sum_m / (8.0F * box.cell_m), 0.0F, 1.0F);
            }
    return density;
}

}  // namespace

MeasuredFrame TankMeasures::measured() {
    MeasuredFrame made = {tank_.frame(kParts, pool_), {}, 0.0};
    surfaces_.make(made.frame, 0.0F, made.surface);
    made.front_x_m = surfaces_.front_x_m();
    return made;
}

TankFiles::TankFiles(std::filesystem::path folder, const FrameFileOptions& options,
                     const tank::LiquidTank& tank, core::ThreadPool& pool)
    : tank_(tank), files_(std::move(folder), "liquid", options, pool), surfaces_(tank.room(), pool) {}

void TankFiles::write(int number, const MeasuredFrame& measured) {
    using enum FrameFiles::Kind;
    files_.costs().triangles = static_cast<std::int64_t>(measured.surface.triangles.size());
    switch (files_.kind()) {
        case Picture:
            return write_picture(number, measured.frame);
        case Mesh:
            return files_.write_mesh(number, measured.surface);
        case Volume:
            return write_volume(number, measured.frame);
        case Scene:
            break;  // the command line offers none
    }
}

void TankFiles::write_picture(int number, const tank::TankFrame& frame) {
    trace::Scene scene = scene_around(tank_.scene().size_m());
    files_.costs().surface_s += seconds_of(
        [&] { surfaces_.make(frame, kReach_cells * tank_.shape().cell_m, scene.clear_liquid); });
    scene.dissolved = frame.milk;
    files_.write_picture(number, scene);
}

void TankFiles::write_volume(int number, const tank::TankFrame& frame) {
    const grid::BoxField density = density_of(frame);
    const liquid::VelocityField& velocity = tank_.velocity();
    files_.write_volume(number,
                        {.density = &density, .velocity_m_s = {&velocity.x, &velocity.y, &velocity.z}});
}

}  // namespace pastoso::cli

#include "cli/tank_files.hpp"

#include "cli/stopwatch.hpp"
#include "tank/solid_mesh.hpp"
#include "trace/tank_scene.hpp"

#include <utility>

#include <glm/common.hpp>

namespace pastoso::cli {
namespace {

/// Points of the surface's lattice along a cell.
constexpr int kParts = 2;
/// Points of the solids' lattice along a cell: they are made once, and edges show.
constexpr int kSolidParts = 3;

/// A volume's edge goes over so much; particles know less than a cell of how deep liquid is.
constexpr float kSoftEdge_cells = 0.5F;

/// The share of liquid at the middles of cells.
grid::BoxField density_of(const tank::TankFrame& frame) {
    grid::BoxField density(frame.milk.shape());
    const grid::BoxShape& box = density.shape();
    const float soft_m = kSoftEdge_cells * box.cell_m;
    for (int k = 0; k < box.nz; ++k)
        for (int j = 0; j < box.ny; ++j)
            for (int i = 0; i < box.nx; ++i) {
                float sum_m = 0.0F;  // of the samples around the middle
                for (int corner = 0; corner < 8; ++corner)
                    sum_m += frame.level_m.at(kParts * (i + 1) + (corner & 1),
                                              kParts * (j + 1) + (corner >> 1 & 1),
                                              kParts * (k + 1) + (corner >> 2));
                density.at(i, j, k) = glm::clamp(0.5F - sum_m / (8.0F * soft_m), 0.0F, 1.0F);
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
    : tank_(tank),
      pool_(pool),
      files_(std::move(folder), "liquid", options, pool),
      surfaces_(tank.domain(), pool) {}

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
    liquid::TriangleMesh surface;
    files_.costs().surface_s += seconds_of([&] {
        surfaces_.make(frame, trace::kTankOverlap_cells * tank_.shape().cell_m, surface);
        if (!solids_) solids_ = tank::solid_mesh(tank_.scene(), kSolidParts, pool_);
    });
    files_.write_picture(number,
                         trace::tank_scene(frame.milk, std::move(surface), *solids_, files_.aspect()));
}

void TankFiles::write_volume(int number, const tank::TankFrame& frame) {
    const grid::BoxField density = density_of(frame);
    const liquid::VelocityField& velocity = tank_.velocity();
    files_.write_volume(number,
                        {.density = &density, .velocity_m_s = {&velocity.x, &velocity.y, &velocity.z}});
}

}  // namespace pastoso::cli

#include "tank/forces.hpp"

#include "core/elementary.hpp"
#include "liquid/flow/confinement.hpp"
#include "liquid/flow/slices.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/vec2.hpp>

namespace pastoso::tank {
namespace {

using liquid::kAxes;
using liquid::RowRange;

constexpr liquid::SolveLimits kViscosityLimits = {1e-4F, 60};
/// Less viscosity than this, as nu dt / cell^2, changes a step by less than the grid's own friction.
constexpr float kLeastViscousStep = 1e-4F;

}  // namespace

void add_gravity_and_wind(const TankScene& scene, const Wind* wind, float dt_s,
                          const grid::BoxField& level_m, float deep_m, const liquid::RowRanges& samples,
                          liquid::VelocityField& velocity, core::ThreadPool& pool) {
    const grid::BoxShape& shape = velocity.shape();
    const float fall_m_s = dt_s * static_cast<float>(scene.gravity_m_s2);
    glm::vec2 wind_m_s(0.0F);
    float drag = 0.0F;
    if (wind != nullptr) {
        const double direction = wind->direction_deg * std::numbers::pi / 180.0;
        wind_m_s = wind->speed_m_s * glm::dvec2(std::cos(direction), std::sin(direction));
        drag =
            static_cast<float>(1.0 - core::exponential(-wind->drag_per_s * static_cast<double>(dt_s)));
    }
    liquid::for_slices(pool, 0, shape.nz + 1, [&](int k) {
        for (int j = 0; j <= shape.ny; ++j) {
            const RowRange row = samples.at(j, k);
            float* w = velocity.z.row(j, k);
            for (int i = row.begin; i < row.end; ++i)
                w[i] -= fall_m_s;
            if (wind == nullptr) continue;
            const float* level = level_m.row(j, k);
            for (const int axis : {0, 1}) {
                float* u = velocity.along(axis).row(j, k);
                const std::ptrdiff_t step = liquid::stride(shape, axis);
                for (int i = row.begin; i < row.end; ++i)
                    if (std::max(level[i], level[i - step]) > -deep_m)
                        u[i] += drag * (wind_m_s[axis] - u[i]);
            }
        }
    });
}

void InnerForces::add(const TankScene& scene, const FreeSurface& surface, float dt_s,
                      liquid::VelocityField& velocity, core::ThreadPool& pool) {
    const float viscosity_m2_s = static_cast<float>(scene.viscosity_m2_s),
                cell_m = velocity.shape().cell_m;
    const bool is_viscous = viscosity_m2_s * dt_s > kLeastViscousStep * cell_m * cell_m;
    const float confinement = static_cast<float>(scene.confinement);
    if (!is_viscous && !(confinement > 0.0F)) return;
    const liquid::Region region = surface.region();
    if (confinement > 0.0F) liquid::add_confinement(region, confinement, dt_s, velocity, pool);
    if (!is_viscous) return;
    for (const int axis : kAxes) {
        auto& diffusion = diffusions_[static_cast<std::size_t>(axis)];
        if (diffusion == nullptr)
            diffusion = std::make_unique<liquid::Diffusion>(region, liquid::face_across(axis),
                                                            liquid::WallFriction::Slips);
        diffusion->region_changed();
        diffusion->diffuse(region, velocity.along(axis), viscosity_m2_s, dt_s, kViscosityLimits, pool);
    }
}

}  // namespace pastoso::tank

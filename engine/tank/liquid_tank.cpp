#include "tank/liquid_tank.hpp"

#include "core/check.hpp"
#include "liquid/confinement.hpp"
#include "liquid/slices.hpp"
#include "tank/sample_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace pastoso::tank {
namespace {

using liquid::kAxes;
using liquid::RowRange;

/// How far the velocity is continued around the particles' cells: a step takes them no further than a
/// cell, and interpolation reads one beyond.
constexpr int kRings = 2;
/// Particles keep so far from walls and solids.
constexpr float kWallGap_cells = 0.02F;
constexpr int kMaxIterations = 60;
constexpr liquid::SolveLimits kViscosityLimits = {1e-4F, 60};
/// Less viscosity than this, as nu dt / cell^2, changes a step by less than the grid's own friction.
constexpr float kLeastViscousStep = 1e-4F;
/// Cells less deep than this are at the surface: particle surfaces know no more.
constexpr float kSurfaceDepth_cells = 0.99F * kParticleRadius_cells;
/// No step mends more of a wrong density than this, as a share of what a full cell holds.
constexpr float kLeastExcess = -0.5F, kMostExcess = 1.0F;

grid::BoxShape shape_of(const TankScene& scene) {
    return {scene.cells.x, scene.cells.y, scene.cells.z, static_cast<float>(scene.cell_m)};
}

liquid::SignedDistance solid_distance(const TankScene& scene) {
    std::vector<ShapeDistance> solids;
    for (const Shape& solid : scene.solids)
        solids.emplace_back(solid);
    const float far_m = glm::length(scene.size_m());
    return [solids, far_m](const glm::vec3& point_m) {
        float nearest_m = far_m;
        for (const ShapeDistance& solid : solids)
            nearest_m = std::min(nearest_m, solid(point_m));
        return nearest_m;
    };
}

bool is_between(double time_s, double from_s, double until_s) {
    return time_s >= from_s && time_s < until_s;
}

}  // namespace

LiquidTank::LiquidTank(const TankScene& scene)
    : scene_((check_tank(scene), scene)),
      room_(shape_of(scene), solid_distance(scene)),
      cells_(shape()),
      transfer_(shape()),
      particle_surface_(room_),
      surface_(room_),
      rings_(shape()),
      velocity_(shape()),
      old_velocity_(shape()),
      known_(shape()),
      growth_(shape()) {
    for (const Drain& drain : scene_.drains)
        drains_.emplace_back(shape(), ShapeDistance(drain.shape));
    for (const Jet& jet : scene_.jets) {
        Nozzle nozzle = {ShapeDistance(jet.shape), {}, 0};
        nozzle.cells = CellSet(shape(), nozzle.form_m);
        nozzle.cells.order_along(jet.velocity_m_s);
        nozzle.full_count = full_count(nozzle.cells, room_, nozzle.form_m);
        nozzles_.push_back(std::move(nozzle));
    }
    Octants octants(shape(), particles_);
    for (auto body = scene_.liquids.rbegin(); body != scene_.liquids.rend(); ++body)
        add(*body, octants);
    core::ThreadPool this_thread(1);
    take_stock(this_thread);
}

void LiquidTank::add(const LiquidBody& body) {
    Octants octants(shape(), particles_);
    add(body, octants);
    core::ThreadPool this_thread(1);
    take_stock(this_thread);
}

TankFrame LiquidTank::frame(int parts, core::ThreadPool& pool) const {
    TankFrame frame = {time_s_, steps_, liquid::SampledField(frame_lattice(shape(), parts)),
                       grid::BoxField(shape())};
    sample_particles(cells_, room_, frame.level_m, pool);
    average_milk(particles_, cells_, frame.milk, pool);
    return frame;
}

void LiquidTank::add(const LiquidBody& body, Octants& octants) {
    const liquid::SignedDistance distance = ShapeDistance(body.shape);
    const Filling filling = {
        room_, distance, {glm::vec3(0.0F), body.milk, body.velocity_m_s}, scene_.seed};
    const float far_m = shape().cell_m;  // no particle of a cell is further from its middle
    for (int k = 0; k < shape().nz; ++k)
        for (int j = 0; j < shape().ny; ++j)
            for (int i = 0; i < shape().nx; ++i)
                if (distance((glm::vec3(i, j, k) + 0.5F) * shape().cell_m) < far_m)
                    fill_cell({i, j, k}, filling, kParticlesPerCell, octants, particles_,
                              particles_made_);
}

void LiquidTank::set_wind(const Wind& wind) {
    TankScene changed = scene_;
    changed.wind = wind;
    check_tank(changed);
    scene_.wind = wind;
}

bool LiquidTank::drain() {
    if (!drains_open_) return false;
    const std::size_t before = particles_.size();
    for (std::size_t d = 0; d < drains_.size(); ++d)
        if (is_between(time_s_, scene_.drains[d].from_s, scene_.drains[d].until_s))
            std::erase_if(particles_, [&](const Particle& particle) {
                return drains_[d].holds(particle.position_m);
            });
    return particles_.size() < before;
}

bool LiquidTank::run_jets() {
    const auto runs = [&](const Jet& jet) { return is_between(time_s_, jet.from_s, jet.until_s); };
    if (std::ranges::none_of(scene_.jets, runs)) return false;
    const std::size_t before = particles_.size();
    Octants octants(shape(), particles_);
    for (std::size_t n = 0; n < nozzles_.size(); ++n)
        if (runs(scene_.jets[n])) run_jet(scene_.jets[n], nozzles_[n], octants);
    return particles_.size() > before;
}

/// What is in the nozzle moves as the jet does; what left it is made up for, upstream first.
void LiquidTank::run_jet(const Jet& jet, const Nozzle& nozzle, Octants& octants) {
    int missing = nozzle.full_count;
    for (Particle& particle : particles_) {
        if (!nozzle.cells.holds(particle.position_m)) continue;
        particle.velocity_m_s = jet.velocity_m_s;
        --missing;
    }
    const Filling filling = {
        room_, nozzle.form_m, {glm::vec3(0.0F), jet.milk, jet.velocity_m_s}, scene_.seed};
    for (const glm::ivec3& cell : nozzle.cells.cells())
        missing -= fill_cell(cell, filling, missing, octants, particles_, particles_made_);
}

double LiquidTank::longest_step_s() const {
    const double falling_m_s = std::sqrt(scene_.gravity_m_s2 * scene_.cell_m);
    return scene_.courant * scene_.cell_m /
           std::max(static_cast<double>(fastest_m_s_) + falling_m_s, 1e-9);
}

TankStep LiquidTank::step(double most_s, core::ThreadPool& pool) {
    PASTOSO_CHECK_OP(most_s, >, 0.0);
    if (drain() | run_jets()) take_stock(pool);
    const double dt_s = most_s / std::ceil(most_s / longest_step_s());
    const float dt = static_cast<float>(dt_s);
    const liquid::RowRanges near = widened_cells(cells_.rows(), shape(), 1);
    samples_ = widened_samples(cells_.rows(), shape(), kRings + 1);
    transfer_.to_faces(particles_, cells_, samples_, velocity_, known_, pool);
    copy_velocity(pool);
    particle_surface_.find(cells_, near, surface_.level_m(), pool);
    surface_.update(near, pool);
    add_forces(dt, pool);
    room_.stop_at_walls(samples_, velocity_, pool);
    add_inner_forces(dt, pool);
    find_growth(near, dt, pool);
    const liquid::SolveResult pressure = surface_.project(
        velocity_, &growth_, {static_cast<float>(scene_.tolerance), kMaxIterations}, pool);
    find_known(pool);
    rings_.extend(known_, samples_, kRings, velocity_, pool);
    room_.stop_at_walls(samples_, velocity_, pool);
    fastest_m_s_ = transfer_.to_particles(old_velocity_, velocity_, samples_,
                                          {static_cast<float>(scene_.flip_share), dt, kWallGap_cells},
                                          particles_, pool);
    if (room_.has_solids()) keep_out_of_solids(pool);
    cells_.sort(particles_, pool);
    time_s_ += dt_s;
    ++steps_;
    return {dt_s, pressure};
}

int LiquidTank::advance_to(double time_s, core::ThreadPool& pool) {
    // What is left by rounding is no step.
    constexpr double kShortest_s = 1e-9;
    const int before = steps_;
    while (time_s - time_s_ > kShortest_s)
        step(time_s - time_s_, pool);
    return steps_ - before;
}

void LiquidTank::copy_velocity(core::ThreadPool& pool) {
    liquid::for_slices(pool, 0, shape().nz + 1, [&](int k) {
        for (int j = 0; j <= shape().ny; ++j) {
            const RowRange row = samples_.at(j, k);
            if (row.empty()) continue;
            for (const int axis : kAxes) {
                const float* from = velocity_.along(axis).row(j, k);
                std::copy(from + row.begin, from + row.end,
                          old_velocity_.along(axis).row(j, k) + row.begin);
            }
        }
    });
}

void LiquidTank::add_forces(float dt_s, core::ThreadPool& pool) {
    const float fall_m_s = dt_s * static_cast<float>(scene_.gravity_m_s2);
    const Wind& wind = scene_.wind;
    const bool blows = wind.speed_m_s > 0.0 && is_between(time_s_, wind.from_s, wind.until_s);
    const double direction = wind.direction_deg * std::numbers::pi / 180.0;
    const glm::vec2 wind_m_s(wind.speed_m_s * std::cos(direction), wind.speed_m_s * std::sin(direction));
    const float drag = static_cast<float>(1.0 - std::exp(-wind.drag_per_s * static_cast<double>(dt_s)));
    const float deep_m = -kSurfaceDepth_cells * shape().cell_m;
    liquid::for_slices(pool, 0, shape().nz + 1, [&](int k) {
        for (int j = 0; j <= shape().ny; ++j) {
            const RowRange row = samples_.at(j, k);
            float* w = velocity_.z.row(j, k);
            for (int i = row.begin; i < row.end; ++i)
                w[i] -= fall_m_s;
            if (!blows) continue;
            const float* level = surface_.level_m().row(j, k);
            for (const int axis : {0, 1}) {
                float* u = velocity_.along(axis).row(j, k);
                const std::ptrdiff_t step = liquid::stride(shape(), axis);
                for (int i = row.begin; i < row.end; ++i)
                    if (std::max(level[i], level[i - step]) > deep_m)
                        u[i] += drag * (wind_m_s[axis] - u[i]);
            }
        }
    });
}

/// Viscosity and the confinement of vorticity: within the liquid, and as if nothing rubbed at its
/// surface and walls.
void LiquidTank::add_inner_forces(float dt_s, core::ThreadPool& pool) {
    const float viscosity_m2_s = static_cast<float>(scene_.viscosity_m2_s), cell_m = shape().cell_m;
    const bool is_viscous = viscosity_m2_s * dt_s > kLeastViscousStep * cell_m * cell_m;
    const float confinement = static_cast<float>(scene_.confinement);
    if (!is_viscous && !(confinement > 0.0F)) return;
    const liquid::Region region = surface_.region();
    if (confinement > 0.0F) liquid::add_confinement(region, confinement, dt_s, velocity_, pool);
    if (!is_viscous) return;
    for (const int axis : kAxes) {
        auto& diffusion = diffusions_[static_cast<std::size_t>(axis)];
        if (diffusion == nullptr)
            diffusion = std::make_unique<liquid::Diffusion>(region, liquid::face_across(axis),
                                                            liquid::WallFriction::Slips);
        diffusion->region_changed();
        diffusion->diffuse(region, velocity_.along(axis), viscosity_m2_s, dt_s, kViscosityLimits, pool);
    }
}

/// Share of a cell's volume that must appear in this step, as a velocity through its faces.
void LiquidTank::find_growth(const liquid::RowRanges& near, float dt_s, core::ThreadPool& pool) {
    particle_surface_.find_excess(cells_, near, surface_.level_m(), growth_, pool);
    const float per_step = static_cast<float>(scene_.volume_rate) * shape().cell_m / dt_s;
    liquid::for_slices(pool, 0, shape().nz, [&](int k) {
        for (int j = 0; j < shape().ny; ++j) {
            const RowRange row = near.at(j, k);
            float* growth = growth_.row(j, k);
            for (int i = row.begin; i < row.end; ++i)
                growth[i] = per_step * std::clamp(growth[i], kLeastExcess, kMostExcess);
        }
    });
}

/// Turns the sums of weights into 1 where the velocity is known: on open faces and the box's own, beside
/// liquid or where particles flew.
void LiquidTank::find_known(core::ThreadPool& pool) {
    const grid::BoxShape& box = shape();
    const std::array<int, 3> last = {box.nx, box.ny, box.nz};
    liquid::for_slices(pool, 0, box.nz + 1, [&](int k) {
        for (int j = 0; j <= box.ny; ++j) {
            const RowRange row = samples_.at(j, k);
            if (row.empty()) continue;
            for (const int axis : kAxes) {
                const std::ptrdiff_t step = liquid::stride(box, axis);
                const float *open = room_.walls().open().along(axis).row(j, k),
                            *liquid = surface_.liquid().row(j, k);
                float* known = known_.along(axis).row(j, k);
                for (int i = row.begin; i < row.end; ++i) {
                    const int at = axis == 0 ? i : axis == 1 ? j : k;
                    const bool passable =
                        open[i] > 0.0F || at == 0 || at == last[static_cast<std::size_t>(axis)];
                    const bool moves = known[i] > 0.0F || liquid[i] > 0.0F || liquid[i - step] > 0.0F;
                    known[i] = passable && moves ? 1.0F : 0.0F;
                }
            }
        }
    });
}

/// The order of the particles is part of the state: it does not depend on who looks at them in between.
void LiquidTank::take_stock(core::ThreadPool& pool) {
    cells_.sort(particles_, pool);
    fastest_m_s_ = 0.0F;
    for (const Particle& particle : particles_)
        for (const int axis : kAxes)
            fastest_m_s_ = std::max(fastest_m_s_, std::abs(particle.velocity_m_s[axis]));
}

void LiquidTank::keep_out_of_solids(core::ThreadPool& pool) {
    const float gap_m = kWallGap_cells * shape().cell_m;
    constexpr std::size_t kRun = 4096;
    pool.run((particles_.size() + kRun - 1) / kRun, [&](std::size_t run, int) {
        const std::size_t end = std::min(particles_.size(), (run + 1) * kRun);
        for (std::size_t p = run * kRun; p < end; ++p)
            particles_[p].position_m = room_.brought_within(particles_[p].position_m, gap_m);
    });
}

}  // namespace pastoso::tank

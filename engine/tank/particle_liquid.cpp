#include "tank/particle_liquid.hpp"

#include "core/error.hpp"
#include "liquid/flow/slices.hpp"
#include "tank/sample_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pastoso::tank {
namespace {

using liquid::kAxes;
using liquid::RowRange;

/// How far the velocity is continued around the particles' cells: a step takes them no further than a
/// cell, and interpolation reads one beyond.
constexpr int kRings = 2;
/// Particles keep so far from walls and solids.
constexpr float kWallGap_cells = 0.02F;
/// Cells less deep than this are at the surface: the level around particles knows no more.
constexpr float kSurfaceDepth_cells = 0.99F * kParticleRadius_cells;
/// No step mends more of a wrong density than this, as a share of what a full cell holds.
constexpr float kLeastExcess = -0.2F, kMostExcess = 0.2F;

}  // namespace

ParticleLiquid::ParticleLiquid(const Domain& domain, std::uint32_t seed)
    : domain_(&domain),
      seed_(seed),
      cells_(domain.shape()),
      transfer_(domain.shape()),
      particle_surface_(domain),
      surface_(domain),
      rings_(domain.shape()),
      velocity_(domain.shape()),
      old_velocity_(domain.shape()),
      known_(domain.shape()),
      growth_(domain.shape()) {}

void ParticleLiquid::add(const LiquidBody& body) {
    Octants octants(shape(), particles_);
    const ShapeDistance exact_m(body.shape);
    const float reach_m = shape().cell_m;  // no particle of a cell is further from its middle
    const liquid::SignedDistance distance = [&](const glm::vec3& at_m) {
        return exact_m(at_m, reach_m);
    };
    const Filling filling = {*domain_, distance, {glm::vec3(0.0F), body.milk, body.velocity_m_s}, seed_};
    for (int k = 0; k < shape().nz; ++k)
        for (int j = 0; j < shape().ny; ++j)
            for (int i = 0; i < shape().nx; ++i)
                if (distance((glm::vec3(i, j, k) + 0.5F) * shape().cell_m) < reach_m)
                    fill_cell({i, j, k}, filling, kParticlesPerCell, octants, particles_, made_);
    in_order_ = false;
}

void ParticleLiquid::drain(const CellSet& cells) {
    const auto gone = std::erase_if(
        particles_, [&](const Particle& particle) { return cells.holds(particle.position_m); });
    in_order_ = in_order_ && gone == 0;
}

void ParticleLiquid::run_jet(const Jet& jet, const Nozzle& nozzle) {
    int missing = nozzle.full_count;
    for (Particle& particle : particles_) {
        if (!nozzle.cells.holds(particle.position_m)) continue;
        particle.velocity_m_s = jet.velocity_m_s;
        --missing;
    }
    Octants octants(shape(), particles_);
    const Filling filling = {
        *domain_, nozzle.form_m, {glm::vec3(0.0F), jet.milk, jet.velocity_m_s}, seed_};
    for (const glm::ivec3& cell : nozzle.cells.cells())
        missing -= fill_cell(cell, filling, missing, octants, particles_, made_);
    in_order_ = false;
}

/// The order of the particles is part of the state: it does not depend on who looks at them in between.
void ParticleLiquid::apply_changes(core::ThreadPool& pool) {
    if (in_order_) return;
    cells_.sort(particles_, pool);
    in_order_ = true;
    fastest_m_s_ = 0.0F;
    for (const Particle& particle : particles_)
        for (const int axis : kAxes)
            fastest_m_s_ = std::max(fastest_m_s_, std::abs(particle.velocity_m_s[axis]));
}

liquid::SolveResult ParticleLiquid::step(const TankScene& scene, const Wind* wind, float dt_s,
                                         core::ThreadPool& pool) {
    const liquid::RowRanges near = widened_cells(cells_.rows(), shape(), 1);
    samples_ = widened_samples(cells_.rows(), shape(), kRings + 1);
    transfer_.to_faces(particles_, cells_, samples_, velocity_, known_, pool);
    copy_velocity(pool);
    particle_surface_.compute(cells_, near, surface_.level_m(), pool);
    surface_.update(near, pool);
    add_gravity_and_wind(scene, wind, dt_s, surface_.level_m(), kSurfaceDepth_cells * shape().cell_m,
                         samples_, velocity_, pool);
    domain_->stop_at_walls(samples_, velocity_, pool);
    inner_forces_.add(scene, surface_, dt_s, velocity_, pool);
    compute_growth(near, scene.volume_rate, dt_s, pool);
    const liquid::SolveResult pressure =
        surface_.project(velocity_, &growth_, pressure_limits(scene), pool);
    compute_known(pool);
    rings_.extend(known_, samples_, kRings, velocity_, pool);
    domain_->stop_at_walls(samples_, velocity_, pool);
    fastest_m_s_ = transfer_.to_particles(old_velocity_, velocity_, samples_,
                                          {static_cast<float>(scene.flip_share), dt_s, kWallGap_cells},
                                          particles_, pool);
    if (domain_->has_solids()) keep_out_of_solids(pool);
    cells_.sort(particles_, pool);
    return pressure;
}

double ParticleLiquid::volume_m3(core::ThreadPool&) const {
    return static_cast<double>(particles_.size()) * shape().cell_volume_m3() / kParticlesPerCell;
}

void ParticleLiquid::show(TankFrame& frame, core::ThreadPool& pool) const {
    sample_particles(cells_, *domain_, frame.level_m, pool);
    average_milk(particles_, cells_, frame.milk, pool);
}

LiquidState ParticleLiquid::state() const {
    return {velocity_, surface_.pressure(), fastest_m_s_, particles_, made_, std::nullopt};
}

void ParticleLiquid::set_state(LiquidState state, core::ThreadPool& pool) {
    if (state.level) throw core::InputError("This is the state of a level set, not of particles.");
    check_shapes(std::array{&state.velocity.x, &state.velocity.y, &state.velocity.z, &state.pressure},
                 shape());
    const glm::vec3 size_m = glm::vec3(shape().nx, shape().ny, shape().nz) * shape().cell_m;
    for (const Particle& particle : state.particles)
        for (const int axis : kAxes)
            if (!(particle.position_m[axis] >= 0.0F && particle.position_m[axis] <= size_m[axis]))
                throw core::InputError("A particle of this state is not within the tank.");
    velocity_ = std::move(state.velocity);
    surface_.set_pressure(std::move(state.pressure));
    fastest_m_s_ = state.fastest_m_s;
    particles_ = std::move(state.particles);
    made_ = state.particles_made;
    cells_.sort(particles_, pool);
    in_order_ = true;
}

void ParticleLiquid::copy_velocity(core::ThreadPool& pool) {
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

/// Share of a cell's volume that must appear in this step, as a velocity through its faces.
void ParticleLiquid::compute_growth(const liquid::RowRanges& near, double volume_rate, float dt_s,
                                    core::ThreadPool& pool) {
    particle_surface_.compute_excess(cells_, near, surface_.level_m(), growth_, pool);
    const float per_step = static_cast<float>(volume_rate) * shape().cell_m / dt_s;
    liquid::for_slices(pool, 0, shape().nz, [&](int k) {
        for (int j = 0; j < shape().ny; ++j) {
            const RowRange row = near.at(j, k);
            float* growth = growth_.row(j, k);
            for (int i = row.begin; i < row.end; ++i)
                growth[i] = per_step * std::clamp(growth[i], kLeastExcess, kMostExcess);
        }
    });
}

/// Turns the sums of weights into what is known of the faces: nothing on shut ones but the box's own.
void ParticleLiquid::compute_known(core::ThreadPool& pool) {
    const grid::BoxShape& box = shape();
    const std::array<int, 3> last = {box.nx, box.ny, box.nz};
    liquid::for_slices(pool, 0, box.nz + 1, [&](int k) {
        for (int j = 0; j <= box.ny; ++j) {
            const RowRange row = samples_.at(j, k);
            if (row.empty()) continue;
            for (const int axis : kAxes) {
                const std::ptrdiff_t step = liquid::stride(box, axis);
                const float *open = domain_->walls().open().along(axis).row(j, k),
                            *liquid = surface_.liquid().row(j, k);
                float* known = known_.along(axis).row(j, k);
                for (int i = row.begin; i < row.end; ++i) {
                    const int at = axis == 0 ? i : axis == 1 ? j : k;
                    const bool passable = open[i] >= kTrustedShare || at == 0 ||
                                          at == last[static_cast<std::size_t>(axis)];
                    const bool is_beside = liquid[i] > 0.0F || liquid[i - step] > 0.0F;
                    known[i] = !passable         ? kUnknownFace
                               : is_beside       ? kLiquidFace
                               : known[i] > 0.0F ? kFlyingFace
                                                 : kUnknownFace;
                }
            }
        }
    });
}

void ParticleLiquid::keep_out_of_solids(core::ThreadPool& pool) {
    const float gap_m = kWallGap_cells * shape().cell_m;
    constexpr std::size_t kRun = 4096;
    pool.run((particles_.size() + kRun - 1) / kRun, [&](std::size_t run, int) {
        const std::size_t end = std::min(particles_.size(), (run + 1) * kRun);
        for (std::size_t p = run * kRun; p < end; ++p)
            particles_[p].position_m = domain_->brought_within(particles_[p].position_m, gap_m);
    });
}

}  // namespace pastoso::tank

#include "tank/level_set_liquid.hpp"

#include "core/error.hpp"
#include "liquid/flow/sampling.hpp"
#include "liquid/flow/slices.hpp"
#include "tank/liquid_volume.hpp"
#include "tank/sample_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pastoso::tank {
namespace {

using liquid::kAxes;
using liquid::Location;
using liquid::RowRange;
using liquid::RowRanges;

/// The velocity is continued so far beyond the reach of phi: what is carried comes from up to a cell
/// away, and interpolation reads one beyond.
constexpr float kVelocityReach_cells = kLevelSetReach_cells + 2.0F;
/// Where less of a cell's origin was liquid, its milk is not known.
constexpr float kLeastShare = 1e-3F;
/// A step makes up for at most this share of the volume.
constexpr double kMostGrowth = 0.02;

/// What lies beyond a field's samples, at the ends of rows, is no part of a state.
grid::BoxField samples_alone(const grid::BoxField& field) {
    const grid::BoxShape& shape = field.shape();
    grid::BoxField alone(shape);
    constexpr int kGhosts = grid::kBoxGhosts;
    for (int k = -kGhosts; k <= shape.nz + kGhosts; ++k)
        for (int j = -kGhosts; j <= shape.ny + kGhosts; ++j) {
            const float* row = field.row(j, k);
            std::copy(row - kGhosts, row + shape.nx + kGhosts + 1, alone.row(j, k) - kGhosts);
        }
    return alone;
}

std::array<RowRanges, 4> no_rows(const grid::BoxShape& shape) {
    return {RowRanges(shape), RowRanges(shape), RowRanges(shape), RowRanges(shape)};
}

}  // namespace

LevelSetLiquid::LevelSetLiquid(const Domain& domain, Method method, std::uint32_t seed)
    : domain_(&domain),
      surface_(domain),
      scheme_(method == Method::UpwindLevelSet ? LevelSetScheme::Upwind
                                               : LevelSetScheme::SemiLagrangian),
      level_advection_(domain.shape()),
      reinitialisation_(domain.shape()),
      extension_(domain.shape()),
      advection_(domain.shape(), no_rows(domain.shape()), liquid::Edges::Walls),
      velocity_(domain.shape()),
      advected_(domain.shape()),
      known_(domain.shape()),
      milk_(domain.shape()),
      advected_milk_(domain.shape()),
      advected_share_(domain.shape()),
      growth_(domain.shape()) {
    std::ranges::fill(level_m().values(), kLevelSetReach_cells * shape().cell_m);
    if (method == Method::ParticleLevelSet) {
        SurfaceParticleSettings settings;
        settings.seed = seed;
        particles_.emplace(shape(), settings);
    }
}

void LevelSetLiquid::add(const LiquidBody& body) {
    const ShapeDistance exact_m(body.shape);
    const float reach_m = kLevelSetReach_cells * shape().cell_m;
    put([&](const glm::vec3& at_m) { return exact_m(at_m, reach_m); }, body.velocity_m_s, body.milk);
    reshaped_ = true;
}

void LevelSetLiquid::run_jet(const Jet& jet, const Nozzle& nozzle) {
    put(nozzle.form_m, jet.velocity_m_s, jet.milk);
    // What is in the nozzle already moves with the jet too.
    for (const glm::ivec3& cell : nozzle.cells.cells()) {
        milk_.at(cell.x, cell.y, cell.z) = jet.milk;
        set_velocity(cell, jet.velocity_m_s);
    }
    if (particles_)
        particles_->remove_where([&](const glm::vec3& at_m) { return nozzle.cells.holds(at_m); });
}

void LevelSetLiquid::set_velocity(const glm::ivec3& cell, const glm::vec3& velocity_m_s) {
    for (const int axis : kAxes) {
        grid::BoxField& u = velocity_.along(axis);
        u.at(cell.x, cell.y, cell.z) = velocity_m_s[axis];
        u.at(cell.x + (axis == 0), cell.y + (axis == 1), cell.z + (axis == 2)) = velocity_m_s[axis];
    }
}

/// The union with what is there. Cells that become liquid get velocity and milk.
void LevelSetLiquid::put(const liquid::SignedDistance& form_m, const glm::vec3& velocity_m_s,
                         float milk) {
    const grid::BoxShape& box = shape();
    for (int k = 0; k < box.nz; ++k)
        for (int j = 0; j < box.ny; ++j)
            for (int i = 0; i < box.nx; ++i) {
                const float distance_m = form_m((glm::vec3(i, j, k) + 0.5F) * box.cell_m);
                float& level = level_m().at(i, j, k);
                if (!(distance_m < level)) continue;
                if (distance_m < 0.0F && level >= 0.0F) {
                    milk_.at(i, j, k) = milk;
                    set_velocity({i, j, k}, velocity_m_s);
                }
                level = distance_m;
                changed_ = true;
            }
}

void LevelSetLiquid::drain(const CellSet& cells) {
    for (const glm::ivec3& cell : cells.cells()) {
        float& level = level_m().at(cell.x, cell.y, cell.z);
        if (level >= 0.0F) continue;
        level = 0.5F * shape().cell_m;
        changed_ = reshaped_ = true;
    }
    if (particles_ && reshaped_)
        particles_->remove_where([&](const glm::vec3& at_m) { return cells.holds(at_m); });
}

void LevelSetLiquid::apply_changes(core::ThreadPool& pool) {
    if (!changed_) return;
    continue_beyond_walls(level_m());
    if (reshaped_) {
        reinitialisation_.apply(level_m(), kLevelSetReach_cells, kept_within_cells(), pool);
        if (particles_) {
            if (particles_->positions_m().empty())
                particles_->seed(level_m(), pool);
            else
                particles_->reseed(level_m(), pool);
        }
    }
    changed_ = reshaped_ = false;
    // What was missing before is still due.
    const double now_m3 = volume_m3(pool);
    due_m3_ += now_m3 - last_m3_;
    last_m3_ = now_m3;
    compute_fastest(pool);
}

double LevelSetLiquid::volume_m3(core::ThreadPool& pool) const {
    if (!domain_->has_solids()) return liquid_volume_m3(surface_.level_m(), pool);
    // What the level set says within solids is no liquid.
    grid::BoxField free_level = surface_.level_m();
    const std::vector<float>& domain = domain_->distance_m().values();
    for (std::size_t n = 0; n < domain.size(); ++n)
        free_level.values()[n] = std::max(free_level.values()[n], -domain[n]);
    return liquid_volume_m3(free_level, pool);
}

/// Cells and samples around the liquid, as far as the level set is known.
void LevelSetLiquid::compute_rows(core::ThreadPool& pool) {
    const grid::BoxShape& box = shape();
    near_ = RowRanges(box);
    const float reach_m = 0.999F * kLevelSetReach_cells * box.cell_m;
    liquid::for_slices(pool, 0, box.nz, [&](int k) {
        for (int j = 0; j < box.ny; ++j) {
            const float* level = surface_.level_m().row(j, k);
            for (int i = 0; i < box.nx; ++i)
                if (level[i] < reach_m) near_.include(i, j, k);
        }
    });
    samples_ = widened_samples(near_, box, 2);
}

liquid::SolveResult LevelSetLiquid::step(const TankScene& scene, const Wind* wind, float dt_s,
                                         core::ThreadPool& pool) {
    compute_rows(pool);
    surface_.update(near_, pool);
    add_gravity_and_wind(scene, wind, dt_s, level_m(), kWindReach_cells * shape().cell_m, samples_,
                         velocity_, pool);
    domain_->stop_at_walls(samples_, velocity_, pool);
    inner_forces_.add(scene, surface_, dt_s, velocity_, pool);
    compute_growth(scene, dt_s);
    const liquid::SolveResult pressure =
        surface_.project(velocity_, &growth_, pressure_limits(scene), pool);
    compute_known(pool);
    extension_.extend(level_m(), known_, kVelocityReach_cells, velocity_, pool);
    domain_->walls().extrapolate(velocity_, pool);
    domain_->stop_at_walls(samples_, velocity_, pool);
    carry_surface(dt_s, pool);
    carry_velocity_and_milk(dt_s, pool);
    last_m3_ = volume_m3(pool);
    compute_fastest(pool);
    return pressure;
}

/// The source's way to keep the volume: a little of what is missing appears everywhere in the liquid.
void LevelSetLiquid::compute_growth(const TankScene& scene, float dt_s) {
    const double volume = last_m3_;
    if (!(volume > 0.0)) return;
    const double missing = std::clamp((due_m3_ - volume) / volume, -kMostGrowth, kMostGrowth);
    const double growth_m_s = scene.volume_rate * missing * scene.cell_m / static_cast<double>(dt_s);
    std::ranges::fill(growth_.values(), static_cast<float>(growth_m_s));
}

/// 1 on open faces beside the liquid and on the box's own.
void LevelSetLiquid::compute_known(core::ThreadPool& pool) {
    const grid::BoxShape& box = shape();
    const std::array<int, 3> last = {box.nx, box.ny, box.nz};
    liquid::for_slices(pool, 0, box.nz + 1, [&](int k) {
        for (int j = 0; j <= box.ny; ++j)
            for (const int axis : kAxes) {
                const std::ptrdiff_t step = liquid::stride(box, axis);
                const float *open = domain_->walls().open().along(axis).row(j, k),
                            *liquid = surface_.liquid().row(j, k);
                float* known = known_.along(axis).row(j, k);
                for (int i = 0; i <= box.nx; ++i) {
                    const int at = axis == 0 ? i : axis == 1 ? j : k;
                    const bool passable = open[i] >= kTrustedShare || at == 0 ||
                                          at == last[static_cast<std::size_t>(axis)];
                    known[i] = passable && (liquid[i] > 0.0F || liquid[i - step] > 0.0F) ? 1.0F : 0.0F;
                }
            }
    });
}

void LevelSetLiquid::carry_surface(float dt_s, core::ThreadPool& pool) {
    level_advection_.advect(level_m(), velocity_, dt_s, kLevelSetReach_cells, scheme_, pool);
    if (particles_) {
        particles_->carry(velocity_, dt_s, pool);
        particles_->mend(level_m(), pool);
    }
    ++steps_;
    if (steps_ % kStepsPerReinitialisation != 0) return;
    reinitialisation_.apply(level_m(), kLevelSetReach_cells, kept_within_cells(), pool);
    if (!particles_) return;
    particles_->mend(level_m(), pool);
    particles_->adjust_radii(level_m(), pool);
    if (steps_ % kStepsPerReseeding == 0) particles_->reseed(level_m(), pool);
}

void LevelSetLiquid::carry_velocity_and_milk(float dt_s, core::ThreadPool& pool) {
    advection_.set_rows({samples_, samples_, samples_, near_});
    advection_.follow(velocity_, pool);
    advected_ = velocity_;
    for (const int axis : kAxes) {
        const liquid::AdvectedPair pair = {&velocity_.along(axis), &advected_.along(axis)};
        advection_.advect({&pair, 1}, liquid::face_across(axis), dt_s,
                          liquid::Interpolation::LimitedCubic, pool);
    }
    carry_milk(dt_s, pool);
    std::swap(velocity_, advected_);
}

/// Only liquid has milk: a cell takes the mean of what was liquid where it comes from.
void LevelSetLiquid::carry_milk(float dt_s, core::ThreadPool& pool) {
    const grid::BoxShape& box = shape();
    const auto for_cells = [&](const auto& body) {
        liquid::for_slices(pool, 0, box.nz, [&](int k) {
            for (int j = 0; j < box.ny; ++j)
                for (int i = near_.at(j, k).begin; i < near_.at(j, k).end; ++i)
                    body(i, j, k);
        });
    };
    for_cells([&](int i, int j, int k) { milk_.at(i, j, k) *= surface_.liquid().at(i, j, k); });
    const std::array<liquid::AdvectedPair, 2> pairs = {
        {{&milk_, &advected_milk_}, {&surface_.liquid(), &advected_share_}}};
    advection_.advect(pairs, Location::Cell, dt_s, liquid::Interpolation::Linear, pool);
    for_cells([&](int i, int j, int k) {
        const float share = advected_share_.at(i, j, k);
        milk_.at(i, j, k) = share > kLeastShare ? advected_milk_.at(i, j, k) / share : 0.0F;
    });
}

void LevelSetLiquid::compute_fastest(core::ThreadPool& pool) {
    const grid::BoxShape& box = shape();
    std::vector<float> fastest(static_cast<std::size_t>(box.nz), 0.0F);
    liquid::for_slices(pool, 0, box.nz, [&](int k) {
        for (int j = 0; j < box.ny; ++j)
            for (int i = 0; i < box.nx; ++i) {
                if (surface_.level_m().at(i, j, k) >= 0.0F) continue;
                for (const int axis : kAxes)
                    fastest[static_cast<std::size_t>(k)] =
                        std::max(fastest[static_cast<std::size_t>(k)],
                                 std::abs(velocity_.along(axis).at(i, j, k)));
            }
    });
    fastest_m_s_ = *std::ranges::max_element(fastest);
}

LiquidState LevelSetLiquid::state() const {
    LevelState level = {samples_alone(surface_.level_m()), milk_, due_m3_, steps_, std::nullopt};
    if (particles_) level.particles = particles_->state();
    return {velocity_, surface_.pressure(), fastest_m_s_, {}, 0, std::move(level)};
}

void LevelSetLiquid::set_state(LiquidState state, core::ThreadPool& pool) {
    if (!state.level || state.level->particles.has_value() != particles_.has_value())
        throw core::InputError("This is the state of a tank that is followed in another way.");
    LevelState& level = *state.level;
    check_shapes(std::array{&state.velocity.x, &state.velocity.y, &state.velocity.z, &state.pressure,
                            &level.level_m, &level.milk},
                 shape());
    if (particles_) particles_->set_state(std::move(*level.particles));
    velocity_ = std::move(state.velocity);
    surface_.set_pressure(std::move(state.pressure));
    fastest_m_s_ = state.fastest_m_s;
    level_m() = std::move(level.level_m);
    milk_ = std::move(level.milk);
    due_m3_ = level.due_m3;
    steps_ = level.steps;
    last_m3_ = volume_m3(pool);
    changed_ = reshaped_ = false;
}

void LevelSetLiquid::show(TankFrame& frame, core::ThreadPool& pool) const {
    sample_level(surface_.level_m(), *domain_, frame.level_m, pool);
    frame.milk = milk_;
}

}  // namespace pastoso::tank

#include "tank/liquid_tank.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "tank/level_set_liquid.hpp"
#include "tank/particle_liquid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace pastoso::tank {
namespace {

grid::BoxShape shape_of(const TankScene& scene) {
    return {scene.cells.x, scene.cells.y, scene.cells.z, static_cast<float>(scene.cell_m)};
}

/// Farther than liquid at a solid's surface feels it.
constexpr float kSolidReach_cells = 8.0F;

/// Exact where less than that reach, which it does not exceed.
liquid::SignedDistance solid_distance(const TankScene& scene) {
    std::vector<ShapeDistance> solids;
    for (const Shape& solid : scene.solids)
        solids.emplace_back(solid);
    const float far_m = kSolidReach_cells * static_cast<float>(scene.cell_m);
    return [solids, far_m](const glm::vec3& point_m) {
        float nearest_m = far_m;
        for (const ShapeDistance& solid : solids)
            nearest_m = std::min(nearest_m, solid(point_m, far_m));
        return std::max(nearest_m, -far_m);
    };
}

bool is_between(double time_s, double from_s, double until_s) {
    return time_s >= from_s && time_s < until_s;
}

std::unique_ptr<LiquidMethod> method_of(const TankScene& scene, const Domain& domain) {
    if (scene.method == Method::Particles) return std::make_unique<ParticleLiquid>(domain, scene.seed);
    return std::make_unique<LevelSetLiquid>(domain, scene.method, scene.seed);
}

}  // namespace

LiquidTank::LiquidTank(const TankScene& scene)
    : scene_((check_tank(scene), scene)),
      domain_(std::make_shared<const Domain>(shape_of(scene), solid_distance(scene))),
      method_(method_of(scene, *domain_)) {
    for (const Drain& drain : scene_.drains)
        drains_.emplace_back(shape(), ShapeDistance(drain.shape));
    for (const Jet& jet : scene_.jets)
        nozzles_.push_back(nozzle_of(jet, *domain_));
    // The later body counts where two meet: it is there first.
    std::for_each(scene_.liquids.rbegin(), scene_.liquids.rend(),
                  [&](const LiquidBody& body) { method_->add(body); });
    core::ThreadPool this_thread(1);
    method_->apply_changes(this_thread);
}

void LiquidTank::add(const LiquidBody& body, core::ThreadPool& pool) {
    TankScene alone;
    alone.liquids = {body};
    check_tank(alone);
    const double before_m3 = volume_m3(pool);
    method_->add(body);
    method_->apply_changes(pool);
    brought_m3_ += volume_m3(pool) - before_m3;
}

void LiquidTank::set_state(TankState state, core::ThreadPool& pool) {
    if (!(state.time_s >= 0.0) || state.steps < 0)
        throw core::InputError("The time of this state is not one of a tank.");
    method_->set_state(std::move(state.liquid), pool);
    time_s_ = state.time_s;
    steps_ = state.steps;
    brought_m3_ = state.brought_m3;
}

TankFrame LiquidTank::frame(int parts, core::ThreadPool& pool) const {
    TankFrame frame = {time_s_, steps_, liquid::SampledField(frame_lattice(shape(), parts)),
                       grid::BoxField(shape())};
    method_->show(frame, pool);
    return frame;
}

void LiquidTank::set_wind(const Wind& wind) {
    TankScene changed = scene_;
    changed.wind = wind;
    check_tank(changed);
    scene_.wind = wind;
}

void LiquidTank::set_numbers(const TankScene& numbers) {
    TankScene changed = scene_;
    for (const TankNumber& number : tank_numbers())
        if (number.value != &TankScene::cell_m) changed.*number.value = numbers.*number.value;
    check_tank(changed);
    scene_ = changed;
}

bool LiquidTank::is_fed_or_drained() const {
    const auto is_open = [&](const auto& one) { return is_between(time_s_, one.from_s, one.until_s); };
    return std::ranges::any_of(scene_.jets, is_open) ||
           (drains_open_ && std::ranges::any_of(scene_.drains, is_open));
}

void LiquidTank::drain() {
    if (!drains_open_) return;
    for (std::size_t d = 0; d < drains_.size(); ++d)
        if (is_between(time_s_, scene_.drains[d].from_s, scene_.drains[d].until_s))
            method_->drain(drains_[d]);
}

void LiquidTank::run_jets() {
    for (std::size_t n = 0; n < nozzles_.size(); ++n)
        if (is_between(time_s_, scene_.jets[n].from_s, scene_.jets[n].until_s))
            method_->run_jet(scene_.jets[n], nozzles_[n]);
}

double LiquidTank::longest_step_s() const {
    const double falling_m_s = std::sqrt(scene_.gravity_m_s2 * scene_.cell_m);
    return scene_.courant * scene_.cell_m /
           std::max(static_cast<double>(method_->fastest_m_s()) + falling_m_s, 1e-9);
}

TankStep LiquidTank::step(double most_s, core::ThreadPool& pool) {
    PASTOSO_CHECK_OP(most_s, >, 0.0);
    const bool changes = is_fed_or_drained();
    const double before_m3 = changes ? volume_m3(pool) : 0.0;
    drain();
    run_jets();
    method_->apply_changes(pool);
    if (changes) brought_m3_ += volume_m3(pool) - before_m3;
    const double dt_s = most_s / std::ceil(most_s / longest_step_s());
    const Wind& wind = scene_.wind;
    const bool blows = wind.speed_m_s > 0.0 && is_between(time_s_, wind.from_s, wind.until_s);
    const liquid::SolveResult pressure =
        method_->step(scene_, blows ? &wind : nullptr, static_cast<float>(dt_s), pool);
    time_s_ += dt_s;
    ++steps_;
    return {dt_s, pressure};
}

int LiquidTank::advance_to(double time_s, core::ThreadPool& pool,
                           const std::function<void(const TankStep&)>& tell) {
    // What is left by rounding is no step.
    constexpr double kShortest_s = 1e-9;
    const int before = steps_;
    while (time_s - time_s_ > kShortest_s) {
        const TankStep done = step(time_s - time_s_, pool);
        if (tell) tell(done);
    }
    return steps_ - before;
}

}  // namespace pastoso::tank

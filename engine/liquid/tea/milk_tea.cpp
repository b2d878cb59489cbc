#include "liquid/tea/milk_tea.hpp"

#include "core/elementary.hpp"
#include "core/error.hpp"
#include "liquid/flow/slices.hpp"
#include "liquid/tea/painters_force.hpp"
#include "liquid/tea/parcel_shape.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace pastoso::liquid {
namespace {

/// More milk than a cell holds (parcels overlap) sinks no faster than this.
constexpr float kMostMilk = 1.2F;
/// Neighbours in memory shall be so in the tea: fields are read where the cache has them.
constexpr int kStepsBetweenSorts = 8;
/// A parcel that is left with less of its milk gives away the rest.
constexpr float kLeastParcel = 0.004F;

grid::BoxShape box_of(const TeaSettings& settings) {
    check_tea(settings);
    const int cells = settings.cells;
    return {cells, cells, cells, static_cast<float>(settings.box_m / cells)};
}

FlowParameters flow_of(const TeaSettings& settings) {
    FlowParameters parameters;
    parameters.viscosity_m2_s = static_cast<float>(settings.viscosity_m2_s);
    parameters.confinement = static_cast<float>(settings.confinement);
    parameters.velocity_advection = settings.advection;
    parameters.pressure.tolerance = static_cast<float>(settings.tolerance);
    return parameters;
}

SignedDistance distance_in(const Cup& cup) {
    return [cup](const glm::vec3& point_m) { return tea_distance_m(cup, point_m); };
}

/// 1 - e^(-dt / time).
float share_passed(double dt_s, double time_s) {
    return static_cast<float>(1.0 - core::exponential(-dt_s / time_s));
}

bool is_worse(const SolveResult& a, const SolveResult& b) {
    return a.residual > b.residual;
}

}  // namespace

MilkTea::MilkTea(const TeaSettings& settings)
    : settings_(settings),
      flow_(box_of(settings), distance_in(settings.cup), flow_of(settings)),
      dissolved_(flow_.shape()),
      coldness_(flow_.shape()),
      balls_(settings),
      parcel_milk_(flow_.shape()),
      total_coldness_(flow_.shape()) {}

void MilkTea::set_settings(const TeaSettings& settings) {
    check_tea(settings);
    const auto fixed = [](const TeaSettings& tea) {
        return std::tuple(tea.cup, tea.cells, tea.box_m, tea.step_s, tea.parcels, tea.milk_m3, tea.seed);
    };
    if (fixed(settings) != fixed(settings_)) {
        throw core::InputError(
            "Cup, box, cells, time step, seed and the recipe's milk cannot change while the tea runs.");
    }
    settings_ = settings;
    flow_.set_parameters(flow_of(settings));
}

TeaStep MilkTea::step(core::ThreadPool& pool, MeasureDivergence measure) {
    const auto dt_s = static_cast<float>(settings_.step_s);
    if (steps_ % kStepsBetweenSorts == 0) sort_by_cells(flow_.shape(), parcels_);
    jug_.pour(settings_, parcels_, flow_.velocity());
    spread_parcels(pool);
    add_buoyancy(pool);
    add_painters_force(settings_, flow_.velocity(), pool);
    flow_.confine_vorticity(dt_s, pool);
    TeaStep result;
    result.diffusion = diffuse(pool);
    result.pressure = flow_.project(pool);
    if (measure == MeasureDivergence::Yes)
        result.divergence_per_s = largest_divergence(flow_.walls(), flow_.velocity());
    carry(pool);
    const SolveResult between = flow_.advect_velocity(dt_s, pool);
    if (is_worse(between, result.pressure)) result.pressure = between;
    exchange(pool);
    erase_dissolved();
    ++steps_;
    return result;
}

TeaFrame MilkTea::frame() const {
    return {time_s(), steps_, parcels_, dissolved_, coldness_};
}

double MilkTea::milk_m3(core::ThreadPool& pool) const {
    double sum = flow_.sum_over_cells(dissolved_, pool) * flow_.shape().cell_volume_m3();
    for (const Parcel& parcel : parcels_)
        sum += static_cast<double>(parcel.volume_m3);
    return sum;
}

void MilkTea::spread_parcels(core::ThreadPool& pool) {
    const auto per_m3 = static_cast<float>(1.0 / flow_.shape().cell_volume_m3());
    compute_shares(parcels_, flow_.walls().open_cells(), pool, shares_);
    amounts_.resize(parcels_.size());
    cold_amounts_.resize(parcels_.size());
    for_parcels(pool, parcels_.size(), [&](std::size_t i) {
        amounts_[i] = parcels_[i].volume_m3 * per_m3;
        cold_amounts_[i] = amounts_[i] * parcels_[i].coldness;
    });
    std::fill(parcel_milk_.values().begin(), parcel_milk_.values().end(), 0.0F);
    total_coldness_ = coldness_;
    scatter(shares_, {{amounts_, cold_amounts_}}, {&parcel_milk_, &total_coldness_}, pool);
}

/// See TeaSettings; on a face, the mean of the cells above and below.
void MilkTea::add_buoyancy(core::ThreadPool& pool) {
    const grid::BoxShape& shape = flow_.shape();
    const auto dt_s = static_cast<float>(settings_.step_s);
    const float fat = 0.5F * dt_s * static_cast<float>(settings_.fat_m_s2),
                cold = dt_s * static_cast<float>(settings_.cold_m_s2),
                heavy = 0.5F * dt_s * static_cast<float>(settings_.dissolved_m_s2);
    for_slices(pool, 1, shape.nz, [&](int k) {
        for (int j = 0; j < shape.ny; ++j) {
            const RowRange range = flow_.walls().rows(Location::FaceZ).at(j, k);
            float* w = flow_.velocity().z.row(j, k);
            const float *milk = parcel_milk_.row(j, k), *milk_below = parcel_milk_.row(j, k - 1),
                        *chill = total_coldness_.row(j, k), *chill_below = total_coldness_.row(j, k - 1),
                        *mixed = dissolved_.row(j, k), *mixed_below = dissolved_.row(j, k - 1);
            for (int i = range.begin; i < range.end; ++i) {
                const float share = std::min(milk[i], kMostMilk) + std::min(milk_below[i], kMostMilk);
                const float coldness = std::min(0.5F * (chill[i] + chill_below[i]), kMostMilk);
                w[i] += fat * share - cold * coldness - heavy * (mixed[i] + mixed_below[i]);
            }
        }
    });
}

SolveResult MilkTea::diffuse(core::ThreadPool& pool) {
    const auto dt_s = static_cast<float>(settings_.step_s);
    SolveResult worst = flow_.diffuse_velocity(dt_s, pool);
    const auto spread = [&](grid::BoxField& field, double diffusivity_m2_s) {
        const SolveResult result =
            flow_.diffuse_cells(field, static_cast<float>(diffusivity_m2_s), dt_s, pool);
        if (is_worse(result, worst)) worst = result;
    };
    spread(coldness_, settings_.heat_diffusion_m2_s);
    spread(dissolved_, settings_.milk_diffusion_m2_s);
    return worst;
}

void MilkTea::carry(core::ThreadPool& pool) {
    const auto dt_s = static_cast<float>(settings_.step_s);
    const std::array<grid::BoxField*, 2> fields = {&dissolved_, &coldness_};
    flow_.advect_cells(fields, dt_s, KeepSum::Yes, pool);

    balls_.nucleate(time_s(), settings_, parcels_);
    positions_m_.resize(parcels_.size());
    for_parcels(pool, parcels_.size(), [&](std::size_t i) { positions_m_[i] = parcels_[i].position_m; });
    deform_parcels(pool);
    flow_.carry(positions_m_, dt_s, pool);
    const float margin_m = kWallMargin_cells * flow_.shape().cell_m;
    for_parcels(pool, parcels_.size(), [&](std::size_t i) {
        parcels_[i].position_m = brought_within(settings_.cup, positions_m_[i], margin_m);
    });
}

void MilkTea::deform_parcels(core::ThreadPool& pool) {
    constexpr std::size_t kAtOnce = 1024;
    const ShapeLimits limits = shape_limits(settings_);
    pool.run((parcels_.size() + kAtOnce - 1) / kAtOnce, [&](std::size_t batch, int) {
        const std::size_t begin = batch * kAtOnce;
        deform(std::span(parcels_).subspan(begin, std::min(kAtOnce, parcels_.size() - begin)),
               flow_.velocity(), static_cast<float>(settings_.step_s), limits);
    });
}

void MilkTea::exchange(core::ThreadPool& pool) {
    const double dt_s = settings_.step_s;
    const float warming_slowly = share_passed(dt_s, settings_.slow_warming_s),
                warming_fast = share_passed(dt_s, settings_.fast_warming_s),
                dissolving = share_passed(dt_s, settings_.dissolving_s),
                dissolving_on_top = share_passed(dt_s, settings_.dissolving_on_top_s),
                dissolving_at_rest = share_passed(dt_s, settings_.dissolving_at_rest_s);
    const auto top_m =
        static_cast<float>(static_cast<double>(settings_.cup.level_m) - settings_.top_depth_m);
    const bool rests = time_s() < settings_.rest_ends_s;
    const auto share_dissolved = [&](const Parcel& parcel) {
        if (parcel.ball >= 0 && static_cast<double>(parcel.coldness) < settings_.warm_below)
            return parcel.position_m.z > top_m ? dissolving_on_top : dissolving;
        return rests ? dissolving_at_rest : dissolving;
    };

    compute_shares(parcels_, flow_.walls().open_cells(), pool, shares_);
    const auto per_m3 = static_cast<float>(1.0 / flow_.shape().cell_volume_m3());
    const float least_m3 = kLeastParcel * milk_per_parcel_m3(settings_);
    for_parcels(pool, parcels_.size(), [&](std::size_t i) {
        Parcel& parcel = parcels_[i];
        amounts_[i] = cold_amounts_[i] = 0.0F;
        if (!shares_[i].any()) return;
        const float warmed = parcel.coldness * (parcel.ball >= 0 ? warming_fast : warming_slowly);
        cold_amounts_[i] =
            static_cast<float>(settings_.chill_share) * parcel.volume_m3 * per_m3 * warmed;
        parcel.coldness -= warmed;
        float given_m3 = parcel.volume_m3 * share_dissolved(parcel);
        if (parcel.volume_m3 - given_m3 < least_m3) given_m3 = parcel.volume_m3;
        parcel.volume_m3 -= given_m3;
        amounts_[i] = given_m3 * per_m3;
    });
    scatter(shares_, {{cold_amounts_, amounts_}}, {&coldness_, &dissolved_}, pool);
}

void MilkTea::erase_dissolved() {
    std::erase_if(parcels_, [](const Parcel& parcel) { return parcel.volume_m3 <= 0.0F; });
}

}  // namespace pastoso::liquid

#include "liquid/tea/milk_tea.hpp"

#include "core/elementary.hpp"
#include "core/error.hpp"
#include "liquid/flow/slices.hpp"
#include "liquid/tea/painters_force.hpp"
#include "liquid/tea/parcel_shape.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include <glm/geometric.hpp>

namespace pastoso::liquid {
namespace {

/// More milk than a cell holds (parcels overlap) sinks no faster than this.
constexpr float kMostMilk = 1.2F;
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
      parcel_coldness_(flow_.shape()),
      sorter_(flow_.shape()) {}

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
    pour();
    add_buoyancy(pool);
    add_painters_force(settings_, flow_.velocity(), pool);
    flow_.confine_vorticity(dt_s, pool);
    TeaStep result;
    result.diffusion = diffuse(pool);
    result.pressure = flow_.project(pool);
    if (measure == MeasureDivergence::Yes)
        result.divergence_per_s = largest_divergence(flow_.walls(), flow_.velocity(), pool);
    carry(pool);
    const SolveResult between = flow_.advect_velocity(dt_s, pool);
    if (is_worse(between, result.pressure)) result.pressure = between;
    exchange(pool);
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

void MilkTea::clear_parcel_fields() {
    for (grid::BoxField* field : {&parcel_milk_, &parcel_coldness_})
        std::ranges::fill(field->values(), 0.0F);
}

void MilkTea::pour() {
    const std::size_t before = parcels_.size();
    jug_.pour(settings_, parcels_, flow_.velocity());
    share_out(std::span(parcels_).subspan(before), flow_.walls().open_cells(), shared_fields(),
              [per_m3 = cells_per_m3()](const Parcel& parcel) { return undissolved(parcel, per_m3); });
}

/// See TeaSettings; on a face, the mean of the cells above and below.
void MilkTea::add_buoyancy(core::ThreadPool& pool) {
    const grid::BoxShape& shape = flow_.shape();
    const auto dt_s = static_cast<float>(settings_.step_s);
    const float fat = 0.5F * dt_s * static_cast<float>(settings_.fat_m_s2),
                cold = dt_s * static_cast<float>(settings_.cold_m_s2),
                heavy = 0.5F * dt_s * static_cast<float>(settings_.dissolved_m_s2);
    grid::BoxField& rise = flow_.velocity().z;
    for_slices(pool, 1, shape.nz, [&](int k) {
        for (int j = 0; j < shape.ny; ++j) {
            const RowRange range = flow_.walls().rows(Location::FaceZ).at(j, k);
            float* w = rise.row(j, k);
            const float *milk = parcel_milk_.row(j, k), *milk_below = parcel_milk_.row(j, k - 1),
                        *chill = coldness_.row(j, k), *chill_below = coldness_.row(j, k - 1),
                        *cold_milk = parcel_coldness_.row(j, k),
                        *cold_milk_below = parcel_coldness_.row(j, k - 1), *mixed = dissolved_.row(j, k),
                        *mixed_below = dissolved_.row(j, k - 1);
            for (int i = range.begin; i < range.end; ++i) {
                const float share = std::min(milk[i], kMostMilk) + std::min(milk_below[i], kMostMilk);
                const float coldness =
                    std::min(0.5F * ((chill[i] + cold_milk[i]) + (chill_below[i] + cold_milk_below[i])),
                             kMostMilk);
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
    const float margin_m = kWallMargin_cells * flow_.shape().cell_m;
    const ShapeLimits limits = shape_limits(settings_);
    for_parcel_blocks(pool, parcels_.size(), [&](std::size_t begin, std::size_t end) {
        deform(std::span(parcels_).subspan(begin, end - begin), flow_.velocity(), dt_s, limits);
        std::array<glm::vec3, kParcelsAtOnce> places_m;
        for (std::size_t i = begin; i < end; ++i)
            places_m[i - begin] = parcels_[i].position_m;
        flow_.carry(std::span(places_m).first(end - begin), dt_s);
        for (std::size_t i = begin; i < end; ++i)
            parcels_[i].position_m = brought_within(settings_.cup, places_m[i - begin], margin_m);
    });
    sorter_.sort(parcels_, pool);
}

/// Parcels give warmth and milk to the tea, and what is left of them is spread for the next step.
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

    const float per_m3 = cells_per_m3();
    const float least_m3 = kLeastParcel * milk_per_parcel_m3(settings_);
    const auto chill_share = static_cast<float>(settings_.chill_share);
    std::atomic<bool> any_gone = false;
    clear_parcel_fields();
    share_out_sorted(parcels_, flow_.walls().open_cells(), shared_fields(), pool, [&](Parcel& parcel) {
        const float warmed = parcel.coldness * (parcel.ball >= 0 ? warming_fast : warming_slowly);
        const float chill = chill_share * parcel.volume_m3 * per_m3 * warmed;
        parcel.coldness -= warmed;
        float given_m3 = parcel.volume_m3 * share_dissolved(parcel);
        if (parcel.volume_m3 - given_m3 < least_m3) {
            given_m3 = parcel.volume_m3;
            any_gone.store(true, std::memory_order_relaxed);
        }
        parcel.volume_m3 -= given_m3;
        SharedAmounts amounts = undissolved(parcel, per_m3);
        amounts[0] = chill;
        amounts[1] = given_m3 * per_m3;
        return amounts;
    });
    if (any_gone) std::erase_if(parcels_, [](const Parcel& parcel) { return parcel.volume_m3 <= 0.0F; });
}

}  // namespace pastoso::liquid

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
/// A stream comes no farther at a time: what it meets has to keep up with it.
constexpr double kStreamWay_cells = 6.0;

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
    : settings_((check_tea(settings), settings)),
      jug_(settings),
      flow_cup_(filled_in_cells(cup(), box_of(settings).cell_m)),
      flow_(std::in_place, box_of(settings), distance_in(flow_cup_), flow_of(settings)),
      dissolved_(flow_->shape()),
      coldness_(flow_->shape()),
      balls_(settings),
      parcel_milk_(flow_->shape()),
      parcel_coldness_(flow_->shape()),
      sorter_(flow_->shape()) {}

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
    flow_->set_parameters(flow_of(settings));
}

int MilkTea::parts_of_step() const {
    const double way_m = settings_.step_s * jug_.arriving_speed_m_s(settings_, settings_.step_s);
    const double most_m = kStreamWay_cells * static_cast<double>(flow_->shape().cell_m);
    return std::max(1, static_cast<int>(std::ceil(way_m / most_m)));
}

TeaStep MilkTea::step(core::ThreadPool& pool, MeasureDivergence measure) {
    balls_.nucleate(time_s(), settings_, parcels_);
    TeaStep worst;
    const int parts = parts_of_step();
    for (int part = 0; part < parts; ++part)
        advance(settings_.step_s / parts, measure, pool, worst);
    ++steps_;
    return worst;
}

void MilkTea::advance(double dt_s, MeasureDivergence measure, core::ThreadPool& pool, TeaStep& worst) {
    const auto dt = static_cast<float>(dt_s);
    const auto room = static_cast<std::size_t>(kMaxParcels) - parcels_.size();
    jug_.pour(settings_, dt_s, room, poured_, flow_->velocity());
    raise_level(pool);
    add_buoyancy(dt, pool);
    add_painters_force(settings_, dt, flow_->velocity(), pool);
    flow_->confine_vorticity(dt, pool);
    const auto note = [](const SolveResult& result, SolveResult& noted) {
        if (is_worse(result, noted)) noted = result;
    };
    note(diffuse(dt, pool), worst.diffusion);
    note(flow_->project(pool), worst.pressure);
    if (measure == MeasureDivergence::Yes)
        worst.divergence_per_s = std::max(worst.divergence_per_s,
                                          largest_divergence(flow_->walls(), flow_->velocity(), pool));
    carry(dt, pool);
    note(flow_->advect_velocity(dt, pool), worst.pressure);
    exchange(dt_s, pool);
}

TeaFrame MilkTea::frame() const {
    return {time_s(), steps_, parcels_, dissolved_, coldness_, pour()};
}

double MilkTea::milk_m3(core::ThreadPool& pool) const {
    double sum = flow_->sum_over_cells(dissolved_, pool) * flow_->shape().cell_volume_m3();
    for (const Parcel& parcel : parcels_)
        sum += static_cast<double>(parcel.volume_m3);
    return sum;
}

void MilkTea::clear_parcel_fields() {
    for (grid::BoxField* field : {&parcel_milk_, &parcel_coldness_})
        std::ranges::fill(field->values(), 0.0F);
}

/// The flow up to the level as it stands, at rest.
void MilkTea::fill_flow() {
    const grid::BoxShape shape = box_of(settings_);
    flow_cup_ = filled_in_cells(cup(), shape.cell_m);
    flow_.emplace(shape, distance_in(flow_cup_), flow_of(settings_));
}

/// Where the level rises, there is what was below it; of milk and cold there is as much as before.
void MilkTea::raise_level(core::ThreadPool& pool) {
    if (filled_in_cells(cup(), flow_->shape().cell_m) == flow_cup_) return;
    const std::array<grid::BoxField*, 2> fields = {&dissolved_, &coldness_};
    std::array<double, 2> sums{};
    for (const std::size_t f : {0, 1}) {
        sums[f] = flow_->sum_over_cells(*fields[f], pool);
        flow_->walls().extrapolate(*fields[f], Location::Cell, pool);
    }
    flow_->walls().extrapolate(flow_->velocity(), pool);
    FlowState state = flow_->state();
    fill_flow();
    flow_->set_state(std::move(state));
    for (const std::size_t f : {0, 1})
        flow_->scale_to_sum(*fields[f], sums[f], pool);
}

/// See TeaSettings; on a face, the mean of the cells above and below.
void MilkTea::add_buoyancy(float dt_s, core::ThreadPool& pool) {
    const grid::BoxShape& shape = flow_->shape();
    const float fat = 0.5F * dt_s * static_cast<float>(settings_.fat_m_s2),
                cold = dt_s * static_cast<float>(settings_.cold_m_s2),
                heavy = 0.5F * dt_s * static_cast<float>(settings_.dissolved_m_s2);
    grid::BoxField& rise = flow_->velocity().z;
    for_slices(pool, 1, shape.nz, [&](int k) {
        for (int j = 0; j < shape.ny; ++j) {
            const RowRange range = flow_->walls().rows(Location::FaceZ).at(j, k);
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

SolveResult MilkTea::diffuse(float dt_s, core::ThreadPool& pool) {
    SolveResult worst = flow_->diffuse_velocity(dt_s, pool);
    const auto spread = [&](grid::BoxField& field, double diffusivity_m2_s) {
        const SolveResult result =
            flow_->diffuse_cells(field, static_cast<float>(diffusivity_m2_s), dt_s, pool);
        if (is_worse(result, worst)) worst = result;
    };
    spread(coldness_, settings_.heat_diffusion_m2_s);
    spread(dissolved_, settings_.milk_diffusion_m2_s);
    return worst;
}

void MilkTea::carry(float dt_s, core::ThreadPool& pool) {
    const std::array<grid::BoxField*, 2> fields = {&dissolved_, &coldness_};
    flow_->advect_cells(fields, dt_s, KeepSum::Yes, pool);

    const Cup filled = cup();
    const float margin_m = kWallMargin_cells * flow_->shape().cell_m;
    const ShapeLimits limits = shape_limits(settings_);
    for_parcel_blocks(pool, parcels_.size(), [&](std::size_t begin, std::size_t end) {
        deform(std::span(parcels_).subspan(begin, end - begin), flow_->velocity(), dt_s, limits);
        std::array<glm::vec3, kParcelsAtOnce> places_m;
        for (std::size_t i = begin; i < end; ++i)
            places_m[i - begin] = parcels_[i].position_m;
        flow_->carry(std::span(places_m).first(end - begin), dt_s);
        for (std::size_t i = begin; i < end; ++i)
            parcels_[i].position_m = brought_within(filled, places_m[i - begin], margin_m);
    });
    // They stand where they have come in this step, and are not carried on.
    parcels_.insert(parcels_.end(), poured_.begin(), poured_.end());
    sorter_.sort(parcels_, pool);
}

/// Parcels give warmth and milk to the tea, and what is left of them is spread for the next step.
void MilkTea::exchange(double dt_s, core::ThreadPool& pool) {
    const float warming_slowly = share_passed(dt_s, settings_.slow_warming_s),
                warming_fast = share_passed(dt_s, settings_.fast_warming_s),
                dissolving = share_passed(dt_s, settings_.dissolving_s),
                dissolving_on_top = share_passed(dt_s, settings_.dissolving_on_top_s),
                dissolving_at_rest = share_passed(dt_s, settings_.dissolving_at_rest_s);
    const float top_m = cup().level_m - static_cast<float>(settings_.top_depth_m);
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
    share_out_sorted(parcels_, flow_->walls().open_cells(), shared_fields(), pool, [&](Parcel& parcel) {
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

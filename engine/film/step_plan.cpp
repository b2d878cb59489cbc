#include "film/step_plan.hpp"

#include "film/explicit/tile_kernels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pastoso::film {
namespace {

using grid::kTileCells;

/// Share of the stability limit that is used; the lateral viscosity takes up to a quarter of it.
constexpr double kStepSafety = 0.7;

/// How far the body force alone may carry paint in a large step, in cells, and how far the air: beyond
/// one cell paint would leave its pigment behind.
constexpr double kCourant = 0.2, kBlownCourant = 1.0;
/// And how far, by the speeds of the step before, where tension may pull.
constexpr double kPulledCourant = 0.5;

/// How far paint goes in an unhurried step, in cells.
constexpr double kUnhurriedCourant = 0.08;
constexpr double kTick_s = 1.0 / 60.0;

/// Of a quotient of times: what is longer by less is not.
constexpr double kRounding = 1e-6;

/// How much faster paint that is blown on may be after a step than before it. What stands against the
/// air, weight and tension, is not in the push: by the push alone a heap that it holds up would race.
constexpr double kQuickening = 2.0, kGust_mm_s = 200.0;

/// What a large step costs, in explicit ones.
constexpr double kLargeStepCost = 4.0;

std::int32_t thickest_quanta(const FilmState& state, int tile) {
    const std::int32_t* values = state.thickness.read(tile);
    return *std::max_element(values, values + kTileCells);
}

/// nu and tau_y/rho of a tile's cells.
struct TileRheology {
    std::array<float, kTileCells> viscosity, yield;
};

TileRheology rheology_of(const PlannedFilm& film, int tile) {
    const auto& kernels = core::kernels<TileKernels>();
    const std::int32_t* thickness = film.state.thickness.read(tile);
    TileRheology rheology;
    if (film.mixed) {
        const auto yield_per_Pa = static_cast<float>(1e6 / film.density_kg_m3);
        kernels.rheology(film.state.paint.read(tile), thickness, kTileCells, yield_per_Pa,
                         rheology.viscosity.data(), rheology.yield.data());
    } else {
        rheology.viscosity.fill(static_cast<float>(film.limits.viscosity_mm2_s));
        rheology.yield.fill(static_cast<float>(film.limits.yield));
    }
    if (film.state.worked.is_in(tile)) {
        std::array<float, kTileCells> structure_share;
        structure_share.fill(static_cast<float>(film.limits.structure_share));
        kernels.loosen(film.state.worked.thickness.read(tile), thickness, kTileCells,
                       structure_share.data(), rheology.viscosity.data(), rheology.yield.data());
    }
    return rheology;
}

/// The largest value(cell, h, nu, tau_y/rho) of a tile's cells.
template <class Value>
double largest_of_cells(const PlannedFilm& film, int tile, const Value& value) {
    const TileRheology rheology = rheology_of(film, tile);
    const std::int32_t* thickness = film.state.thickness.read(tile);
    double largest = 0.0;
    for (int cell = 0; cell < kTileCells; ++cell)
        if (thickness[cell] > 0)
            largest = std::max(largest, value(cell, thickness_mm(thickness[cell]),
                                              rheology.viscosity[cell], rheology.yield[cell]));
    return largest;
}

/// What the body force alone makes of the paint of a tile that it carries fastest, at most.
double fastest_speed_mm_s(const PlannedFilm& film, int tile) {
    if (!film.varied)
        return film.limits.fastest_speed_mm_s(thickness_mm(thickest_quanta(film.state, tile)));
    return largest_of_cells(film, tile, [&](int, double h, double viscosity, double yield) {
        return film.limits.fastest_speed_mm_s(h, viscosity, yield);
    });
}

/// For paint that may be at rest: its waves, and what the body force will make of it.
double resting_step_s(const PlannedFilm& film, int tile) {
    const double thickest_mm = thickness_mm(thickest_quanta(film.state, tile));
    const double waves_s =
        film.varied ? film.limits.resting_step_s(
                          thickest_mm, largest_of_cells(film, tile,
                                                        [](int, double h, double viscosity, double) {
                                                            return h * h * h / viscosity;
                                                        }))
                    : film.limits.newtonian_step_s(thickest_mm);
    return std::min(waves_s, film.limits.advection_step_s(fastest_speed_mm_s(film, tile)));
}

/// The largest value(tile) of these tiles.
template <class Value>
double largest_of_tiles(const PlannedFilm& film, const std::vector<int>& tiles, const Value& value) {
    std::vector<double> values(tiles.size() + 1);
    film.pool.run(tiles.size(), [&](std::size_t index, int) { values[index] = value(tiles[index]); });
    return *std::max_element(values.begin(), values.end());
}

/// What the body force alone makes of the paint that it carries fastest, at most.
double fastest_speed_mm_s(const PlannedFilm& film) {
    const std::vector<int> tiles = film.activity.stepping_tiles();
    if (!film.varied) {
        std::int32_t thickest = 0;
        for (const int tile : tiles)
            thickest = std::max(thickest, thickest_quanta(film.state, tile));
        return film.limits.fastest_speed_mm_s(thickness_mm(thickest));
    }
    return largest_of_tiles(film, tiles, [&](int tile) { return fastest_speed_mm_s(film, tile); });
}

/// The push of all jets on a cell, mm/s2, at most.
double push_mm_s2(const PlannedFilm& film, const grid::Rect& tile_cells, int cell) {
    const double x_mm = (tile_cells.x0 + cell % grid::kTileSize + 0.5) * film.state.cell_mm;
    const double y_mm = (tile_cells.y0 + cell / grid::kTileSize + 0.5) * film.state.cell_mm;
    double push = 0.0;
    for (const AirJet& jet : film.air)
        push += air_push_mm_s2(jet, film.density_kg_m3, x_mm, y_mm);
    return push;
}

bool is_reached(const PlannedFilm& film, int tile) {
    const grid::Rect cells = film.state.shape.tile_cells(tile);
    return std::any_of(film.air.begin(), film.air.end(), [&](const AirJet& jet) {
        return !grid::intersection(cells, cells_reached(jet, film.state.shape, film.state.cell_mm))
                    .empty();
    });
}

/// What the air makes of the paint that it blows on, together with the body force, at most: thick paint
/// in the still middle of a jet is not taken for the thin paint at its rim.
double fastest_blown_speed_mm_s(const PlannedFilm& film) {
    std::vector<int> blown;
    for (const int tile : film.activity.stepping_tiles())
        if (is_reached(film, tile)) blown.push_back(tile);
    return largest_of_tiles(film, blown, [&](int tile) {
        const grid::Rect cells = film.state.shape.tile_cells(tile);
        const double bound_mm_s =
            largest_of_cells(film, tile, [&](int cell, double h, double viscosity, double yield) {
                StepLimits pushed = film.limits;
                pushed.force_mm_s2 += push_mm_s2(film, cells, cell);
                return pushed.fastest_speed_mm_s(h, viscosity, yield);
            });
        const double measured_mm_s = film.activity.tile(tile).extremes.speed_mm_s;
        return std::min(bound_mm_s, kQuickening * measured_mm_s + kGust_mm_s);
    });
}

/// How long a step may be, however fast the paint in it settles.
double hurried_step_s(const SolverOptions& options) {
    return std::max(kTick_s, options.longest_wait_s);
}

/// The same by the speeds of the step before, where they are known.
double unhurried_step_s(const PlannedFilm& film, double hurried_s) {
    double speed_mm_s = 0.0;
    for (const int tile : film.activity.stepping_tiles()) {
        const TileActivity& flow = film.activity.tile(tile);
        if (!flow.measured || flow.changed_from_outside) return hurried_s;
        speed_mm_s = std::max(speed_mm_s, static_cast<double>(flow.extremes.speed_mm_s));
    }
    return std::max(hurried_s, kUnhurriedCourant * film.state.cell_mm / (speed_mm_s + 1e-30));
}

/// What the pull of tension has made of the paint in the last step.
double fastest_pulled_speed_mm_s(const PlannedFilm& film) {
    if (!film.pulled) return 0.0;
    double speed_mm_s = 0.0;
    for (const int tile : film.activity.stepping_tiles())
        speed_mm_s =
            std::max(speed_mm_s, static_cast<double>(film.activity.tile(tile).extremes.speed_mm_s));
    return speed_mm_s;
}

StepPlan plan_large_step(const PlannedFilm& film, const SolverOptions& options, double seconds) {
    const double cell_mm = film.state.cell_mm;
    const double own_per_s = fastest_speed_mm_s(film) / (kCourant * cell_mm);
    const double blown_per_s = fastest_blown_speed_mm_s(film) / (kBlownCourant * cell_mm);
    const double pulled_per_s = fastest_pulled_speed_mm_s(film) / (kPulledCourant * cell_mm);
    const double wanted_per_s = std::max({own_per_s, blown_per_s, pulled_per_s});
    const double steps_per_s = std::min(wanted_per_s, kMostLargeSteps_per_s);
    const double longest_s =
        std::min(unhurried_step_s(film, hurried_step_s(options)), 1.0 / (steps_per_s + 1e-30));
    return {.step_s = seconds / std::max(1.0, std::ceil(seconds / longest_s - kRounding)),
            .large = true,
            .lags = wanted_per_s > kMostLargeSteps_per_s};
}

double stable_step_s(const PlannedFilm& film) {
    double limit = std::numeric_limits<double>::max();
    for (const int tile : film.activity.stepping_tiles()) {
        const TileActivity& flow = film.activity.tile(tile);
        limit = std::min(limit, flow.changed_from_outside ? resting_step_s(film, tile)
                                                          : film.limits.flowing_step_s(flow.extremes));
    }
    return kStepSafety * limit;
}

}  // namespace

bool is_unhurried(double dt_s, const SolverOptions& options) {
    return dt_s > hurried_step_s(options) * (1.0 + kRounding);
}

bool went_too_far(double dt_s, double speed_mm_s, double cell_mm) {
    return speed_mm_s * dt_s > 2.0 * kUnhurriedCourant * cell_mm;
}

StepPlan plan_step(const PlannedFilm& film, const SolverOptions& options, double seconds) {
    if (options.fixed_step_s > 0.0) return {options.fixed_step_s, options.scheme == Scheme::LargeStep};
    if (options.scheme == Scheme::LargeStep) return plan_large_step(film, options, seconds);
    const double explicit_s = stable_step_s(film);
    if (options.scheme == Scheme::Explicit) return {explicit_s, false};
    const StepPlan large = plan_large_step(film, options, seconds);
    return large.step_s > kLargeStepCost * explicit_s ? large : StepPlan{explicit_s, false};
}

}  // namespace pastoso::film

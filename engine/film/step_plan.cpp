#include "film/step_plan.hpp"

#include "film/tile_kernels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace pastoso::film {
namespace {

using grid::kTileCells;

/// Share of the stability limit that is used; the lateral viscosity takes up to a quarter of it.
constexpr double kStepSafety = 0.7;

/// What a large step costs, in explicit ones.
constexpr double kLargeStepCost = 4.0;

std::int32_t thickest_quanta(const FilmState& state, int tile) {
    const std::int32_t* values = state.thickness.read(tile);
    return *std::max_element(values, values + kTileCells);
}

/// The largest value(h, nu, tau_y/rho) of a tile's cells.
template <class Value>
double largest_of_cells(const PlannedFilm& film, int tile, const Value& value) {
    std::array<float, kTileCells> viscosity{}, yield{};
    const std::int32_t* thickness = film.state.thickness.read(tile);
    const auto yield_per_Pa = static_cast<float>(1e6 / film.density_kg_m3);
    tile_kernels().rheology(film.state.paint.read(tile), thickness, kTileCells, yield_per_Pa,
                            viscosity.data(), yield.data());
    double largest = 0.0;
    for (int cell = 0; cell < kTileCells; ++cell)
        largest = std::max(largest, value(thickness_mm(thickness[cell]), viscosity[cell], yield[cell]));
    return largest;
}

double resting_step_s(const PlannedFilm& film, int tile) {
    const double thickest_mm = thickness_mm(thickest_quanta(film.state, tile));
    if (!film.state.varied) return film.limits.newtonian_step_s(thickest_mm);
    return film.limits.resting_step_s(
        thickest_mm, largest_of_cells(film, tile, [](double h, double viscosity, double) {
            return h * h * h / viscosity;
        }));
}

/// What the body force alone makes of the paint in these tiles that it carries fastest, at most.
double fastest_speed_mm_s(const PlannedFilm& film, const StepLimits& forces,
                          const std::vector<int>& tiles) {
    if (!film.state.varied) {
        std::int32_t thickest = 0;
        for (const int tile : tiles)
            thickest = std::max(thickest, thickest_quanta(film.state, tile));
        return forces.fastest_speed_mm_s(thickness_mm(thickest));
    }
    std::vector<double> fastest(tiles.size() + 1);
    film.pool.run(tiles.size(), [&](std::size_t index, int) {
        fastest[index] =
            largest_of_cells(film, tiles[index], [&](double h, double viscosity, double yield) {
                return forces.fastest_speed_mm_s(h, viscosity, yield);
            });
    });
    return *std::max_element(fastest.begin(), fastest.end());
}

/// The same of all paint that is stepped, where it is blown on with the push of the air.
double fastest_speed_mm_s(const PlannedFilm& film) {
    const std::vector<int> tiles = film.activity.stepping_tiles();
    double speed = fastest_speed_mm_s(film, film.limits, tiles);
    for (const AirJet& jet : film.air) {
        const grid::Rect reached = cells_reached(jet, film.state.shape, film.state.cell_mm);
        std::vector<int> blown;
        std::copy_if(tiles.begin(), tiles.end(), std::back_inserter(blown), [&](int tile) {
            return !grid::intersection(film.state.shape.tile_cells(tile), reached).empty();
        });
        StepLimits pushed = film.limits;
        pushed.force_mm_s2 += strongest_push_mm_s2(jet, film.density_kg_m3);
        speed = std::max(speed, fastest_speed_mm_s(film, pushed, blown));
    }
    return speed;
}

double large_step_s(const PlannedFilm& film, double seconds) {
    const double speed = fastest_speed_mm_s(film);
    constexpr double kCourant = 0.2;
    return seconds / std::max(1.0, std::ceil(seconds * speed / (kCourant * film.state.cell_mm)));
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

StepPlan plan_step(const PlannedFilm& film, const SolverOptions& options, double seconds) {
    if (options.fixed_step_s > 0.0) return {options.fixed_step_s, options.scheme == Scheme::LargeStep};
    if (options.scheme == Scheme::LargeStep) return {large_step_s(film, seconds), true};
    const double explicit_s = stable_step_s(film);
    if (options.scheme == Scheme::Explicit) return {explicit_s, false};
    const double large_s = large_step_s(film, seconds);
    return large_s > kLargeStepCost * explicit_s ? StepPlan{large_s, true} : StepPlan{explicit_s, false};
}

}  // namespace pastoso::film

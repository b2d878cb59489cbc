#include "film/solver.hpp"

#include "core/check.hpp"
#include "core/units.hpp"
#include "film/explicit/halo_block.hpp"
#include "film/explicit/strata_transport.hpp"
#include "film/explicit/tile_update.hpp"
#include "film/large/large_step.hpp"
#include "film/solver_state.hpp"
#include "film/step_plan.hpp"
#include "film/step_setup.hpp"
#include "film/tile_activity.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pastoso::film {
namespace {

using grid::TileBlock;

/// How often a large step that does not converge is cut in half before its best is taken.
constexpr int kMostHalvings = 6;

/// Paint that rests stiffens slowly beside all else: so many calls of advance() at a time, all taken to be
/// as long as the last.
constexpr int kCallsOfRest = 6;

}  // namespace

Gravity tilted_gravity(double tilt_deg, double direction_deg) {
    const double tilt = core::radians(tilt_deg), direction = core::radians(direction_deg);
    const double along = core::kStandardGravity_mm_s2 * std::sin(tilt);
    return {.normal_mm_s2 = core::kStandardGravity_mm_s2 * std::cos(tilt),
            .x_mm_s2 = along * std::cos(direction),
            .y_mm_s2 = along * std::sin(direction)};
}

void AdvanceReport::add(const AdvanceReport& other) {
    steps += other.steps;
    cells_stepped += other.cells_stepped;
    large_steps += other.large_steps;
    clamped_faces += other.clamped_faces;
    rejected_steps += other.rejected_steps;
    limited_cells += other.limited_cells;
    lagging_steps += other.lagging_steps;
    sweeps += other.sweeps;
    largest_residual = std::max(largest_residual, other.largest_residual);
    largest_speed_mm_s = std::max(largest_speed_mm_s, other.largest_speed_mm_s);
    awake_tiles = other.awake_tiles;
}

struct Solver::Parts {
    Parts(FilmState& film, const Medium& paint, const SolverOptions& solver_options,
          core::ThreadPool& threads)
        : state(film),
          medium(paint),
          options(solver_options),
          pool(threads),
          activity(film.shape, film.cell_mm, solver_options.sleeping,
                   solver_options.edge_x == Edge::Periodic, solver_options.edge_y == Edge::Periodic),
          window_start(film.shape.tile_count()),
          large(film.shape, solver_options.edge_x, solver_options.edge_y, threads.thread_count()),
          scratch(threads.thread_count()) {
        for (int x = 0; x < film.shape.tiles_x(); ++x)
            columns.push_back(make_halo_map(x, film.shape.width, options.edge_x));
        for (int y = 0; y < film.shape.tiles_y(); ++y)
            rows.push_back(make_halo_map(y, film.shape.height, options.edge_y));
        for (auto& worker : scratch)
            worker = std::make_unique<WorkerScratch>();
        configure();
    }

    void configure() {
        check_medium(medium);
        consistency = consistency_of(medium);
        follow_state();
    }

    /// A state that has become another one may come from the time of another medium, whose numbers wet
    /// paint keeps.
    void follow_state() {
        const FilmNumbers own = film_numbers_of(medium);
        if (state.media.numbers.empty() || !has_wet_paint(state))
            state.media.become_one(own);
        else
            add_medium(state, own);
        set_numbers(own);
        state.worked.follow(
            std::any_of(state.media.numbers.begin(), state.media.numbers.end(),
                        [](const FilmNumbers& numbers) { return numbers.structure_share > 0.0; }));
    }

    void set_numbers(const FilmNumbers& numbers) {
        const Medium paint = with_film_numbers(medium, numbers);
        limits = make_limits(paint, gravity, state.cell_mm);
        constants = make_constants(paint, gravity, options, state.cell_mm);
        density_kg_m3 = paint.density_kg_m3;
    }

    /// Sets the numbers of the media that the next step has to do with.
    void follow_media();
    /// Which medium all paint is of that a step of these places looks at; none where there are several.
    std::optional<int> only_medium(const std::vector<TilePlace>& places) const;

    /// Whether what each cell carries has to be looked at.
    bool is_mixed() const { return !state.consistencies.are_only(consistency); }
    bool is_varied() const { return is_mixed() || constants.media || state.worked.is_anywhere(); }
    StepConstants constants_of(double dt_s) const {
        StepConstants step = constants;
        step.dt_s = static_cast<float>(dt_s);
        step.mixed = is_mixed();
        step.varied = is_varied();
        return step;
    }

    bool on_canvas_edge(int tile, Side side) const {
        const int x = tile % state.shape.tiles_x(), y = tile / state.shape.tiles_x();
        switch (side) {
            case kLeft:
                return x == 0;
            case kRight:
                return x == state.shape.tiles_x() - 1;
            case kTop:
                return y == 0;
            default:
                return y == state.shape.tiles_y() - 1;
        }
    }
    Edge edge_kind(Side side) const {
        return side == kLeft || side == kRight ? options.edge_x : options.edge_y;
    }
    bool runs_off(int tile, Side side) const {
        return on_canvas_edge(tile, side) && edge_kind(side) == Edge::Open;
    }
    bool canvas_ends(int tile, Side side) const {
        return on_canvas_edge(tile, side) && edge_kind(side) != Edge::Periodic;
    }
    bool is_closed(int tile, Side side) const {
        if (canvas_ends(tile, side))
            return edge_kind(side) == Edge::Wall || !activity.tile(tile).stepping;
        return !activity.exchange(tile, activity.neighbour(tile, side));
    }
    /// The tiles that take part in a step, and those that only exchange paint with them.
    std::vector<TilePlace> places_to_step() const;

    /// Clear paint carries nothing: true when this tile or one beside it holds pigment.
    bool pigment_in_reach(int tile) const {
        if (!state.paint.is_background(tile)) return true;
        for (int side = 0; side < kSideCount; ++side) {
            const int other = activity.neighbour(tile, static_cast<Side>(side));
            if (other >= 0 && !state.paint.is_background(other)) return true;
        }
        return false;
    }

    TilePlace place_of(int tile) const;
    void replace_fields(int tile, TileResult& result);
    void commit(int tile, float dt_s, TileResult& result, AdvanceReport& report);
    void put_to_sleep(int tile);
    AdvanceReport commit_all(const std::vector<TilePlace>& places, float dt_s,
                             std::vector<TileResult>& results);
    AdvanceReport explicit_step(double dt_s);
    AdvanceReport large_step(double dt_s, bool unhurried, int halvings = 0);
    /// False when it was cancelled before the time had passed. step_group() is for the tiles that
    /// take part.
    bool step_group(double seconds, const std::function<bool()>& cancelled, AdvanceReport& report);
    bool advance(double seconds, const std::function<bool()>& cancelled, AdvanceReport& report);

    FilmState& state;
    Medium medium;
    SolverOptions options;
    core::ThreadPool& pool;
    Gravity gravity = tilted_gravity(0.0);
    std::vector<AirJet> air;
    std::shared_ptr<const grid::Mask> cover;
    StepLimits limits;
    StepConstants constants;
    double density_kg_m3 = 1000.0;
    Consistency consistency;  ///< of the medium
    ActivityMap activity;
    std::vector<TileBlock<std::int32_t>> window_start;  ///< thickness when a tile's window began
    LargeStepper large;
    std::vector<HaloMap> columns, rows;
    std::vector<std::unique_ptr<WorkerScratch>> scratch;
    Totals runoff;
};

TilePlace Solver::Parts::place_of(int tile) const {
    const int tile_x = tile % state.shape.tiles_x(), tile_y = tile / state.shape.tiles_x();
    const auto& reference =
        activity.window_begins(tile) ? state.thickness.block(tile) : window_start[tile];
    return {.tile = tile,
            .tile_x = tile_x,
            .columns = columns[tile_x],
            .rows = rows[tile_y],
            .closed = {is_closed(tile, kLeft), is_closed(tile, kRight), is_closed(tile, kTop),
                       is_closed(tile, kBottom), !activity.tile(tile).stepping},
            .runoff_edges = {runs_off(tile, kLeft), runs_off(tile, kRight), runs_off(tile, kTop),
                             runs_off(tile, kBottom)},
            .canvas_edges = {canvas_ends(tile, kLeft), canvas_ends(tile, kRight),
                             canvas_ends(tile, kTop), canvas_ends(tile, kBottom)},
            .air = air,
            .cover = cover.get(),
            .density_kg_m3 = density_kg_m3,
            .pigment_in_reach = pigment_in_reach(tile),
            .motion_reference = reference.read()};
}

std::vector<TilePlace> Solver::Parts::places_to_step() const {
    std::vector<TilePlace> places;
    for (int tile = 0; tile < state.shape.tile_count(); ++tile) {
        bool takes_part = activity.tile(tile).stepping;
        for (int side = 0; side < kSideCount && !takes_part; ++side) {
            const int other = activity.neighbour(tile, static_cast<Side>(side));
            takes_part = other >= 0 && activity.exchange(tile, other);
        }
        if (takes_part) places.push_back(place_of(tile));
    }
    return places;
}

void Solver::Parts::replace_fields(int tile, TileResult& result) {
    if (result.thickness) state.thickness.replace(tile, std::move(result.thickness));
    if (result.paint) state.paint.replace(tile, std::move(result.paint));
    if (result.worked) state.worked.replace(tile, std::move(result.worked));
    if (result.media) state.media.replace(tile, std::move(result.media));
    if (result.velocity_x) state.velocity_x.replace(tile, std::move(result.velocity_x));
    if (result.velocity_y) state.velocity_y.replace(tile, std::move(result.velocity_y));
}

void Solver::Parts::commit(int tile, float dt_s, TileResult& result, AdvanceReport& report) {
    if (activity.window_begins(tile)) window_start[tile] = state.thickness.block(tile);
    replace_fields(tile, result);
    runoff.thickness += result.runoff.thickness;
    for (int k = 0; k < kPaintChannels; ++k)
        runoff.paint[k] += result.runoff.paint[k];
    const grid::Rect cells = state.shape.tile_cells(tile);
    report.cells_stepped += static_cast<std::int64_t>(cells.width()) * cells.height();
    report.clamped_faces += result.extremes.clamped_faces;
    report.largest_speed_mm_s =
        std::max(report.largest_speed_mm_s, static_cast<double>(result.extremes.speed_mm_s));
    if (activity.record(tile, dt_s, result.motion, result.extremes, result.side_speeds_mm_s))
        put_to_sleep(tile);
}

void Solver::Parts::put_to_sleep(int tile) {
    window_start[tile] = {};
    large.forget(tile);
    state.velocity_x.reset(tile);
    state.velocity_y.reset(tile);
    join_like_strata(state, tile);
    settle_media(state, tile);
}

std::optional<int> Solver::Parts::only_medium(const std::vector<TilePlace>& places) const {
    std::optional<int> only;
    const auto differs = [&](int tile) {
        if (state.thickness.is_background(tile)) return false;
        if (!only) only = state.media.own[tile];
        return state.media.is_mixed(tile) || state.media.own[tile] != *only;
    };
    for (const TilePlace& place : places)
        if (any_tile_near(place, state.shape.tiles_x(), differs)) return std::nullopt;
    return only.value_or(0);
}

void Solver::Parts::follow_media() {
    if (!state.media.are_several()) return;
    const std::optional<int> only = only_medium(places_to_step());
    set_numbers(only ? state.media.numbers[*only] : bounds_of(state.media.numbers));
    constants.media = !only;
}

AdvanceReport Solver::Parts::commit_all(const std::vector<TilePlace>& places, float dt_s,
                                        std::vector<TileResult>& results) {
    pool.run(places.size(), [&](std::size_t index, int) {
        if (!results[index].lower.empty())
            change_lower(state.lower, places[index].tile, results[index].lower);
    });
    AdvanceReport report;
    report.steps = 1;
    for (std::size_t index = 0; index < places.size(); ++index) {
        if (places[index].closed.inside)
            replace_fields(places[index].tile, results[index]);
        else
            commit(places[index].tile, dt_s, results[index], report);
    }
    report.awake_tiles = activity.awake_count();
    return report;
}

AdvanceReport Solver::Parts::explicit_step(double dt_s) {
    const std::vector<TilePlace> places = places_to_step();
    const StepConstants step = constants_of(dt_s);
    std::vector<TileResult> results(places.size());
    pool.run(places.size(), [&](std::size_t index, int worker) {
        results[index] = update_tile(state, places[index], step, *scratch[worker]);
    });
    return commit_all(places, step.dt_s, results);
}

AdvanceReport Solver::Parts::large_step(double dt_s, bool unhurried, int halvings) {
    const std::vector<TilePlace> places = places_to_step();
    StepConstants step = constants_of(dt_s);
    step.unhurried = unhurried;
    LargeStepReport solved;
    std::vector<TileResult> results =
        large.step(state, places, step, pool, scratch, halvings == kMostHalvings, solved);
    const auto too_far = [&] {
        return step.unhurried &&
               std::any_of(results.begin(), results.end(), [&](const TileResult& result) {
                   return went_too_far(dt_s, result.extremes.speed_mm_s, state.cell_mm);
               });
    };
    const bool is_usable = !results.empty() && (halvings == kMostHalvings || !too_far());
    if (!is_usable && !places.empty()) {
        const double half_s = 0.5 * dt_s;
        const bool still_unhurried = unhurried && is_unhurried(half_s, options);
        AdvanceReport report = large_step(half_s, still_unhurried, halvings + 1);
        report.add(large_step(half_s, still_unhurried, halvings + 1));
        report.rejected_steps += solved.draws_back ? 0 : 1;
        return report;
    }
    AdvanceReport report = commit_all(places, step.dt_s, results);
    large.settle(state, places, pool, scratch);
    report.large_steps = 1;
    report.limited_cells = solved.limited_cells;
    report.clamped_faces += solved.clamped_faces;
    report.sweeps = solved.sweeps;
    report.largest_residual = solved.residual;
    return report;
}

bool Solver::Parts::step_group(double seconds, const std::function<bool()>& cancelled,
                               AdvanceReport& report) {
    double remaining = seconds;
    while (remaining > 0.0 && !activity.stepping_tiles().empty()) {
        if (cancelled()) return false;
        follow_media();
        const StepPlan next =
            plan_step({state, activity, limits, air, density_kg_m3, is_mixed(), is_varied(),
                       constants.media && tensions_differ(state.media.numbers), pool},
                      options, remaining);
        // A remainder of one part in a million is rounding, not a step of its own.
        const double steps_left = std::max(1.0, std::ceil(remaining / next.step_s - 1e-6));
        const double dt_s = remaining / steps_left;
        const bool unhurried = options.fixed_step_s == 0.0 && is_unhurried(dt_s, options);
        report.add(next.large ? large_step(dt_s, unhurried) : explicit_step(dt_s));
        report.lagging_steps += next.lags ? 1 : 0;
        remaining = steps_left > 1.0 ? remaining - dt_s : 0.0;
    }
    return true;
}

bool Solver::Parts::advance(double seconds, const std::function<bool()>& cancelled,
                            AdvanceReport& report) {
    activity.let_pass(seconds, options.longest_wait_s);
    while (const std::optional<double> waited_s = activity.begin_group())
        if (!step_group(*waited_s, cancelled, report)) return false;
    if (activity.calls() % kCallsOfRest == 0) recover(state, kCallsOfRest * seconds, pool);
    report.awake_tiles = activity.awake_count();
    return true;
}

Solver::Solver(FilmState& state, const Medium& medium, const SolverOptions& options,
               core::ThreadPool& pool)
    : parts_(std::make_unique<Parts>(state, medium, options, pool)) {
    wake_all();
}

Solver::~Solver() = default;

void Solver::reshape() {
    auto parts = std::make_unique<Parts>(parts_->state, parts_->medium, parts_->options, parts_->pool);
    parts->gravity = parts_->gravity;
    parts->air = parts_->air;
    parts->runoff = parts_->runoff;
    parts->configure();
    parts_ = std::move(parts);
    wake_all();
}

void Solver::set_medium(const Medium& medium) {
    parts_->medium = medium;
    parts_->configure();
    wake_all();
}

const Consistency& Solver::consistency() const {
    return parts_->consistency;
}

void Solver::set_gravity(const Gravity& gravity) {
    if (gravity == parts_->gravity) return;
    parts_->gravity = gravity;
    parts_->configure();
    wake_all();
}

void Solver::set_air(const std::vector<AirJet>& jets) {
    if (jets == parts_->air) return;
    parts_->air = jets;
    parts_->configure();
    for (const AirJet& jet : jets)
        wake(cells_reached(jet, parts_->state.shape, parts_->state.cell_mm));
}

void Solver::set_cover(std::shared_ptr<const grid::Mask> cover) {
    PASTOSO_CHECK(!cover || cover->shape() == parts_->state.shape);
    parts_->cover = std::move(cover);
}

void Solver::wake(const grid::Rect& cells) {
    const grid::Rect tiles = parts_->state.shape.tiles_touching(cells);
    for (int y = tiles.y0; y < tiles.y1; ++y)
        for (int x = tiles.x0; x < tiles.x1; ++x)
            parts_->activity.wake(y * parts_->state.shape.tiles_x() + x);
}

void Solver::wake_all() {
    parts_->follow_state();
    for (int tile = 0; tile < parts_->state.shape.tile_count(); ++tile)
        if (!parts_->state.thickness.is_background(tile)) parts_->activity.wake(tile);
}

std::vector<bool> Solver::awake_tiles() const {
    std::vector<bool> awake(parts_->window_start.size());
    for (std::size_t tile = 0; tile < awake.size(); ++tile)
        awake[tile] = parts_->activity.tile(static_cast<int>(tile)).awake;
    return awake;
}

void Solver::restart(const std::vector<bool>& awake) {
    PASTOSO_CHECK_OP(awake.size(), ==, parts_->window_start.size());
    parts_->follow_state();
    parts_->activity.restore(parts_->activity.calls(), std::vector<TileActivity>(awake.size()));
    parts_->window_start.assign(awake.size(), {});
    parts_->large.restore(LargeStepper::Pressures(awake.size()));
    for (std::size_t tile = 0; tile < awake.size(); ++tile)
        if (awake[tile]) parts_->activity.wake(static_cast<int>(tile));
}

AdvanceReport Solver::advance(double seconds) {
    AdvanceReport report;
    parts_->advance(
        seconds, [] { return false; }, report);
    return report;
}

std::optional<AdvanceReport> Solver::advance_unless(const std::function<bool()>& cancelled,
                                                    double seconds) {
    const FilmState state = parts_->state;
    const ActivityMap activity = parts_->activity;
    const auto window_start = parts_->window_start;
    const Totals runoff = parts_->runoff;
    LargeStepper::Pressures pressures = parts_->large.pressures();
    AdvanceReport report;
    if (parts_->advance(seconds, cancelled, report)) return report;
    parts_->state = state;
    parts_->activity = activity;
    parts_->window_start = window_start;
    parts_->runoff = runoff;
    parts_->large.restore(std::move(pressures));
    return std::nullopt;
}

AdvanceReport Solver::step(double dt_s) {
    const bool large = parts_->options.scheme == Scheme::LargeStep;
    parts_->activity.step_all();
    parts_->follow_media();
    const AdvanceReport report = large ? parts_->large_step(dt_s, false) : parts_->explicit_step(dt_s);
    recover(parts_->state, dt_s, parts_->pool);
    return report;
}

double Solver::stable_step_s(double thickness) const {
    return parts_->limits.newtonian_step_s(thickness);
}

const Totals& Solver::runoff() const {
    return parts_->runoff;
}

int Solver::awake_tile_count() const {
    return parts_->activity.awake_count();
}

SolverState Solver::state() const {
    SolverState state{.calls = parts_->activity.calls(), .runoff = parts_->runoff};
    const LargeStepper::Pressures& pressures = parts_->large.pressures();
    for (int tile = 0; tile < parts_->state.shape.tile_count(); ++tile) {
        const TileActivity& activity = parts_->activity.tile(tile);
        if (activity.awake) {
            state.awake.push_back({tile, activity, {}});
            if (activity.window_s > 0.0F) state.awake.back().window_start = parts_->window_start[tile];
        }
        if (pressures[tile]) state.pressures.push_back({tile, pressures[tile]});
    }
    return state;
}

void Solver::restore(const SolverState& state) {
    std::vector<TileActivity> tiles(parts_->state.shape.tile_count());
    parts_->window_start.assign(tiles.size(), {});
    for (const SolverState::AwakeTile& awake : state.awake) {
        PASTOSO_CHECK(awake.window_start || awake.activity.window_s == 0.0F);
        tiles[awake.tile] = awake.activity;
        parts_->window_start[awake.tile] = awake.window_start;
    }
    parts_->activity.restore(state.calls, std::move(tiles));
    LargeStepper::Pressures pressures(parts_->window_start.size());
    for (const SolverState::TilePressure& known : state.pressures)
        pressures[known.tile] = known.pressure_mm2_s2;
    parts_->large.restore(std::move(pressures));
    parts_->runoff = state.runoff;
}

}  // namespace pastoso::film

#include "film/large/large_step.hpp"

#include "film/large/large_tile_kernels.hpp"
#include "film/large/settling.hpp"

#include <algorithm>
#include <array>

namespace pastoso::film {
namespace {

using grid::kTileSize;

/// A relative error of flux that is not worth another pass with refined drag.
constexpr float kSteadyFlux = 0.01F;
constexpr int kMostRefinements = 6;
/// The same where paint is solved closely.
constexpr float kSteadyCloseFlux = 0.005F;
constexpr int kMostCloseRefinements = 40;
/// How far paint that creeps goes in a step, at most, and how long that is: longer ones are of paint
/// that waited, and too few for their errors to sum up.
constexpr float kCreep_cells = 0.01F, kCreepingStep_s = 0.017F;
/// How far an end of the film may draw back in a step, in cells, but for steps as short as that.
constexpr float kMostRetreat_cells = 0.25F, kShortestRetreat_s = 1.0F / 480.0F;
/// A thickness error below this, relative to the film, needs no further sweep.
constexpr float kTolerance = 0.01F;
constexpr float kCloseTolerance = 0.0005F;
/// What a sweep leaves of the error, at most, where the overlap does its work.
constexpr float kSweepGain = 0.1F;
constexpr int kMostSweeps = 12;
/// Of a slow tile.
constexpr int kMostCycles = 8;
/// An error above this makes the step unfit for use.
constexpr float kUsable = 0.25F;
constexpr int kMostSharePasses = 6;
constexpr int kMostSlowings = 6;
/// So many cells of a tile may run empty without a new solution: what they lack is seen nowhere.
constexpr int kFewShortCells = 2;
/// What is left, after another step, of how many tiles count as needed lately.
constexpr double kStillNeeded = 0.99;

struct CellRange {
    int begin, end;
};

/// The cells of a patch along an axis, as far as they are on a canvas whose edges there are open.
CellRange cells_within(Edge edge, const std::vector<WindowRun>& patch) {
    if (edge != Edge::Open) return {0, kPatchSize};
    constexpr int kPatchBegin = kWindowMargin - kOverlap;
    return {std::max(0, patch.front().position - kPatchBegin),
            std::min(kPatchSize, patch.back().position + patch.back().count - kPatchBegin)};
}

/// Whether the drag of some paint at the faces of a tile depends on how fast it flows.
bool drag_follows_flow(const StepConstants& constants, const HaloBlock& block) {
    if (constants.is_shear_thinning()) return true;
    if (!constants.varied) return constants.has_yield();
    for (int y = -1; y <= kTileSize; ++y)
        for (int x = -1; x <= kTileSize; ++x) {
            const int i = block_index(x, y);
            if (block.yield[i] > 0.0F && block.quanta[i] > 0) return true;
        }
    return false;
}

/// Both tiles hold the same bits of the faces between them, or paint would be lost there. A tile that is
/// refined beside a steady one puts these faces back as they were.
class SharedFaces {
  public:
    /// `beside` holds the tiles to the left, right, above and below.
    SharedFaces(const TilePlace& place, const std::array<LargeTile*, 4>& beside, const LargeTile& tile) {
        const int right = place.columns.extent - 1, bottom = place.rows.extent - 1;
        const auto is_steady = [&](int side) {
            return beside[side] != nullptr && !beside[side]->state.is_unsteady();
        };
        for (int k = 0; k < kTileSize; ++k) {
            if (is_steady(0)) keep(tile.x, face_index(-1, k), x_faces_);
            if (is_steady(1)) keep(tile.x, face_index(right, k), x_faces_);
            if (is_steady(2)) keep(tile.y, face_index(k, -1), y_faces_);
            if (is_steady(3)) keep(tile.y, face_index(k, bottom), y_faces_);
        }
    }
    /// Puts them back. Returns whether there were any.
    bool restore(LargeTile& tile) const {
        restore(x_faces_, tile.x);
        restore(y_faces_, tile.y);
        return !x_faces_.empty() || !y_faces_.empty();
    }

  private:
    static constexpr std::array kKept{&LargeFaces::driven,     &LargeFaces::across, &LargeFaces::drag,
                                      &LargeFaces::resistance, &LargeFaces::depth,  &LargeFaces::star,
                                      &LargeFaces::mobility};
    struct Face {
        int index;
        std::array<float, kKept.size()> values;
    };
    static void keep(const LargeFaces& faces, int f, std::vector<Face>& kept) {
        Face face{f, {}};
        for (std::size_t k = 0; k < kKept.size(); ++k)
            face.values[k] = (faces.*kKept[k])[f];
        kept.push_back(face);
    }
    static void restore(const std::vector<Face>& kept, LargeFaces& faces) {
        for (const Face& face : kept)
            for (std::size_t k = 0; k < kKept.size(); ++k)
                (faces.*kKept[k])[face.index] = face.values[k];
    }
    std::vector<Face> x_faces_, y_faces_;
};

}  // namespace

LargeScratch::LargeScratch() {
    int size = kPatchSize;
    for (MultigridLevel& level : levels) {
        level.size = size;
        for (auto* values :
             {&level.pressure, &level.change, &level.pressure_source, &level.change_source,
              &level.mobility_x, &level.mobility_y, &level.weight_x, &level.weight_y, &level.inverse,
              &level.pressure_residual, &level.change_residual})
            values->assign(level.count(), 0.0F);
        size /= 2;
    }
}

/// One step under way.
struct LargeStepper::Pass {
    LargeStepper& stepper;
    const FilmState& state;
    const std::vector<TilePlace>& places;
    const StepConstants& constants;
    core::ThreadPool& pool;
    std::vector<std::unique_ptr<WorkerScratch>>& workers;
    const LargeKernels& kernels = core::kernels<LargeKernels>();

    bool backwards = false;

    /// Calls visit(index, tile, scratch, worker) for every tile, on all threads. Each time it goes back
    /// the way it came, over the tiles that are still in the cache.
    template <class Visit>
    void for_each_tile(const Visit& visit) {
        pool.run(places.size(), [&](std::size_t turn, int worker) {
            const std::size_t index = index_of(turn);
            visit(index, tile_of(places[index]), *stepper.scratch_[worker], *workers[worker]);
        });
        backwards = !backwards;
    }
    std::size_t index_of(std::size_t turn) const { return backwards ? places.size() - 1 - turn : turn; }

    /// The places whose test(place, tile) says yes, in the order in which the next visit is to go.
    using ChosenPlaces = std::vector<const TilePlace*>;
    template <class Test>
    ChosenPlaces places_where(const Test& test) const {
        ChosenPlaces chosen;
        for (std::size_t turn = 0; turn < places.size(); ++turn) {
            const TilePlace& place = places[index_of(turn)];
            if (test(place, tile_of(place))) chosen.push_back(&place);
        }
        return chosen;
    }
    /// Calls visit(place, tile, scratch, worker) for these, on all threads.
    template <class Visit>
    void for_each_of(const ChosenPlaces& chosen, const Visit& visit) {
        pool.run(chosen.size(), [&](std::size_t index, int worker) {
            visit(*chosen[index], tile_of(*chosen[index]), *stepper.scratch_[worker], *workers[worker]);
        });
        if (!chosen.empty()) backwards = !backwards;
    }
    LargeTile& tile_of(const TilePlace& place) const { return *stepper.tiles_[place.tile]; }

    /// Where an error stays: in inertial paint as energy, in a long step as much as a short one makes in
    /// the time of many, and in paint that creeps since a yield stress lets nothing flow back.
    bool is_solved_closely(const LargeTile& tile) const {
        return tile.inertial || constants.unhurried || is_creeping(tile);
    }
    bool is_creeping(const LargeTile& tile) const {
        return (constants.has_yield() || constants.varied) && constants.dt_s < kCreepingStep_s &&
               tile.fastest_mm_s * constants.dt_s < kCreep_cells * constants.cell_mm;
    }
    /// Whether ends of the film would draw back so far that shorter steps are to follow them.
    bool draws_back_too_far() const {
        if (constants.dt_s < 1.001F * kShortestRetreat_s) return false;
        return std::any_of(places.begin(), places.end(), [&](const TilePlace& place) {
            return tile_of(place).fastest_retreat_mm_s * constants.dt_s >
                   kMostRetreat_cells * constants.cell_mm;
        });
    }
    float tolerance_of(const LargeTile& tile) const {
        return is_solved_closely(tile) ? kCloseTolerance : kTolerance;
    }
    /// Whether the sweep that found a tile's error has brought it below what is allowed.
    bool is_close(const LargeTile& tile) const {
        return tile.state.error() * kSweepGain <= tolerance_of(tile);
    }

    const Windows& columns(const TilePlace& place) const { return stepper.columns_[place.tile_x]; }
    const Windows& rows(const TilePlace& place) const {
        return stepper.rows_[place.tile / state.shape.tiles_x()];
    }
    /// The tile that takes part in the step at these tile coordinates, or null.
    LargeTile* partner(int tile_x, int tile_y) const {
        const int tile = tile_y * state.shape.tiles_x() + tile_x;
        return stepper.tiles_[tile];
    }
    /// The same for coordinates that may be one beyond the canvas: periodic edges lead to the other
    /// side.
    LargeTile* neighbour(int tile_x, int tile_y) const {
        const auto wrapped = [](int index, int count, Edge edge) {
            return edge == Edge::Periodic ? (index + count) % count : index;
        };
        const int count_x = state.shape.tiles_x(), count_y = state.shape.tiles_y();
        const int x = wrapped(tile_x, count_x, stepper.edge_x_);
        const int y = wrapped(tile_y, count_y, stepper.edge_y_);
        return x < 0 || y < 0 || x >= count_x || y >= count_y ? nullptr : partner(x, y);
    }
    auto cells(CellArray LargeTile::*field) const {
        return [this, field](int tile_x, int tile_y, int y) -> const float* {
            const LargeTile* tile = partner(tile_x, tile_y);
            return tile == nullptr ? nullptr : (tile->*field).data() + y * kTileSize;
        };
    }
    auto last_pressures() const {
        return [this](int tile_x, int tile_y, int y) -> const float* {
            const int tile = tile_y * state.shape.tiles_x() + tile_x;
            const grid::TileBlock<float>& pressure = stepper.last_pressures_[tile];
            if (stepper.tiles_[tile] == nullptr || !pressure) return nullptr;
            return pressure.read() + y * kTileSize;
        };
    }
    auto thickness_rows() const {
        return [this](int tile_x, int tile_y, int y) {
            return state.thickness.read(tile_y * state.shape.tiles_x() + tile_x) + y * kTileSize;
        };
    }
    /// None of those that do not take part, whose pressure nobody knows.
    auto partners_thickness() const {
        return [this](int tile_x, int tile_y, int y) -> const std::int32_t* {
            if (partner(tile_x, tile_y) == nullptr) return nullptr;
            return thickness_rows()(tile_x, tile_y, y);
        };
    }
    auto faces(LargeFaces LargeTile::*direction, FaceArray<float> LargeFaces::*field) const {
        return [this, direction, field](int tile_x, int tile_y, int y) -> const float* {
            const LargeTile* tile = partner(tile_x, tile_y);
            return tile == nullptr ? nullptr : (tile->*direction.*field).data() + face_index(0, y);
        };
    }
    template <class RowOf>
    void gather_patch(const TilePlace& place, const RowOf& row_of, WindowArray& out) const {
        gather_window(columns(place).patch, rows(place).patch, kWindowSize, kWindowStride, row_of,
                      &out[window_index(-kWindowMargin, -kWindowMargin)]);
    }
    template <class RowOf, class T>
    void gather_next(const TilePlace& place, const RowOf& row_of,
                     std::array<T, kWindowCells>& out) const {
        gather_window(columns(place).next_cells, rows(place).next_cells, kTileSize + 2, kWindowStride,
                      row_of, &out[window_index(-1, -1)]);
    }

    float assemble(const TilePlace& place, bool again, LargeTile& tile, LargeScratch& large,
                   WorkerScratch& worker) const;
    float refine(const TilePlace& place, LargeTile& tile, LargeScratch& large,
                 WorkerScratch& worker) const;
    void assemble_all();
    std::array<LargeTile*, 4> beside(const TilePlace& place) const;
    grid::Rect patch_within_open_edges(const TilePlace& place) const;
    void gather_x_faces(const TilePlace& place, FaceArray<float> LargeFaces::*field,
                        WindowArray& out) const;
    void gather_y_faces(const TilePlace& place, FaceArray<float> LargeFaces::*field,
                        WindowArray& out) const;
    bool refine_all(int pass);
    void solve_yielding(LargeStepReport& report);
    template <class Test>
    bool any_around(const TilePlace& place, const Test& test) const;
    void answer_pressure();
    void compute_residuals(bool first);
    ChosenPlaces places_to_correct(bool first);
    void correct(bool first);
    void blend();
    float largest_error() const;
    bool has_rough_cover(const TilePlace& place) const;
    std::vector<PatchCover> patch_covers(const TilePlace& place) const;
    float sweep(bool first);
    void solve(bool from_rest, LargeStepReport& report);
    void share_outflow(const TilePlace& place, LargeTile& tile, LargeScratch& large,
                       CellArray& share) const;
    void compute_velocities(const TilePlace& place, LargeTile& tile, LargeScratch& large) const;
    void share_held();
    void share_inflow();
    bool runs_short(int cells) const;
    void slow_limited_faces();
    void solve_within_supply(LargeStepReport& report);
    std::vector<TileResult> finish();
};

/// Assembles a tile; see LargeKernels::assemble.
float LargeStepper::Pass::assemble(const TilePlace& place, bool again, LargeTile& tile,
                                   LargeScratch& large, WorkerScratch& worker) const {
    gather_tile(state, place, constants, worker);
    const auto gather_lagged = [&](const auto& row_of) {
        gather_window(columns(place).next_cells, rows(place).next_cells, kTileSize + 2, kBlockStride,
                      row_of, &large.lagged_pressure[block_index(-1, -1)]);
    };
    if (again)
        gather_lagged(cells(&LargeTile::pressure));
    else
        gather_lagged(last_pressures());
    return kernels.assemble(constants, place.columns.extent, place.rows.extent, place.closed,
                            place.canvas_edges, again, large, worker.tile, tile);
}

/// Takes a tile's drag from the pressure found. Returns by what part a flux was wrong.
float LargeStepper::Pass::refine(const TilePlace& place, LargeTile& tile, LargeScratch& large,
                                 WorkerScratch& worker) const {
    if (!constants.is_shear_thinning()) {
        gather_next(place, partners_thickness(), large.thickness);
        return kernels.refine(constants, large, tile);
    }
    kernels.velocities(constants, false, large, tile);
    return assemble(place, true, tile, large, worker);
}

void LargeStepper::Pass::assemble_all() {
    for_each_tile([&](std::size_t index, LargeTile& tile, LargeScratch& large, WorkerScratch& worker) {
        assemble(places[index], false, tile, large, worker);
        tile.state.begin_step();
        if (!drag_follows_flow(constants, worker.tile.block)) tile.state.steady_drag();
    });
}

/// The tiles to the left, right, above and below, null where none takes part.
std::array<LargeTile*, 4> LargeStepper::Pass::beside(const TilePlace& place) const {
    const int x = place.tile_x, y = place.tile / state.shape.tiles_x();
    return {neighbour(x - 1, y), neighbour(x + 1, y), neighbour(x, y - 1), neighbour(x, y + 1)};
}

/// The cells of a tile's patch within the canvas' open edges. Other edges let nothing pass anyway.
grid::Rect LargeStepper::Pass::patch_within_open_edges(const TilePlace& place) const {
    const auto [x0, x1] = cells_within(stepper.edge_x_, columns(place).patch);
    const auto [y0, y1] = cells_within(stepper.edge_y_, rows(place).patch);
    return {x0, y0, x1, y1};
}

/// The window of a coefficient of the x faces. Those on the left of a tile that has none beside it are
/// in no other tile.
void LargeStepper::Pass::gather_x_faces(const TilePlace& place, FaceArray<float> LargeFaces::*field,
                                        WindowArray& out) const {
    gather_patch(place, faces(&LargeTile::x, field), out);
    for (const WindowRun& row : rows(place).patch) {
        const LargeTile* tile = partner(place.tile_x, row.tile);
        if (tile == nullptr || neighbour(place.tile_x - 1, row.tile) != nullptr) continue;
        for (int k = 0; k < row.count; ++k)
            out[window_index(-1, row.position + k - kWindowMargin)] =
                (tile->x.*field)[face_index(-1, row.cell + k)];
    }
}

/// The same of the y faces, and those above a tile.
void LargeStepper::Pass::gather_y_faces(const TilePlace& place, FaceArray<float> LargeFaces::*field,
                                        WindowArray& out) const {
    gather_patch(place, faces(&LargeTile::y, field), out);
    const int tile_y = place.tile / state.shape.tiles_x();
    for (const WindowRun& column : columns(place).patch) {
        const LargeTile* tile = partner(column.tile, tile_y);
        if (tile == nullptr || neighbour(column.tile, tile_y - 1) != nullptr) continue;
        for (int k = 0; k < column.count; ++k)
            out[window_index(column.position + k - kWindowMargin, -1)] =
                (tile->y.*field)[face_index(column.cell + k, -1)];
    }
}

/// Takes the drag of all faces from the pressure found, in the unsteady tiles. Faces that they share
/// with a steady one stay as they are: both must hold the same. Returns false when no flux was wrong by
/// much.
bool LargeStepper::Pass::refine_all(int pass) {
    const ChosenPlaces unsteady =
        places_where([](const TilePlace&, const LargeTile& tile) { return tile.state.is_unsteady(); });
    for_each_of(unsteady, [&](const TilePlace& place, LargeTile& tile, LargeScratch& large,
                              WorkerScratch& worker) {
        const SharedFaces kept(place, beside(place), tile);
        gather_next(place, cells(&LargeTile::pressure), large.pressure);
        tile.flux_error = refine(place, tile, large, worker);
        if (kept.restore(tile)) kernels.compute_source(constants, tile);
        kernels.compute_change(large, tile);
        tile.state.change_equations();
    });
    for (const TilePlace* place : unsteady)
        tile_of(*place).state.steady_drag();
    bool changes = false;
    for (const TilePlace* place : unsteady) {
        LargeTile& tile = tile_of(*place);
        const bool closely = is_solved_closely(tile) && !constants.is_shear_thinning();
        if (tile.flux_error <= (closely ? kSteadyCloseFlux : kSteadyFlux)) continue;
        changes = true;
        if (!closely && pass + 1 >= kMostRefinements) continue;
        tile.state.unsettle_drag();
        for (LargeTile* neighbour : beside(*place))
            if (neighbour != nullptr) neighbour->state.unsettle_drag();
    }
    return changes;
}

/// Whether any of the tiles that a tile's patch reads passes the test.
template <class Test>
bool LargeStepper::Pass::any_around(const TilePlace& place, const Test& test) const {
    for (const WindowRun& row : rows(place).patch)
        for (const WindowRun& column : columns(place).patch)
            if (const LargeTile* tile = partner(column.tile, row.tile); tile && test(*tile)) return true;
    return false;
}

/// Of the tiles' last errors; a NaN counts as larger than all.
float LargeStepper::Pass::largest_error() const {
    float result = 0.0F;
    for (const TilePlace& place : places) {
        const float error = stepper.tiles_[place.tile]->state.error();
        if (!(error <= result)) result = error;
    }
    return result;
}

/// The corrections that reach a tile.
std::vector<PatchCover> LargeStepper::Pass::patch_covers(const TilePlace& place) const {
    std::vector<PatchCover> covers;
    for (const WindowRun& row : rows(place).covers)
        for (const WindowRun& column : columns(place).covers)
            if (const LargeTile* tile = partner(column.tile, row.tile);
                tile && tile->state.is_corrected())
                covers.push_back({.correction = &tile->correction,
                                  .x = column.cell,
                                  .y = row.cell,
                                  .width = column.count,
                                  .height = row.count,
                                  .patch_x = column.position,
                                  .patch_y = row.position});
    return covers;
}

/// Whether a correction that reaches a tile is too large to be trusted without another look.
bool LargeStepper::Pass::has_rough_cover(const TilePlace& place) const {
    for (const WindowRun& row : rows(place).covers)
        for (const WindowRun& column : columns(place).covers)
            if (const LargeTile* tile = partner(column.tile, row.tile);
                tile && tile->state.is_corrected() && !is_close(*tile))
                return true;
    return false;
}

/// The changes of thickness where the last sweep moved the pressure.
void LargeStepper::Pass::answer_pressure() {
    const ChosenPlaces stale = places_where(
        [](const TilePlace&, const LargeTile& tile) { return tile.state.change_is_stale(); });
    for_each_of(stale,
                [&](const TilePlace& place, LargeTile& tile, LargeScratch& large, WorkerScratch&) {
                    gather_next(place, cells(&LargeTile::pressure), large.pressure);
                    kernels.compute_change(large, tile);
                    tile.state.answer_pressure();
                });
}

/// The residuals of changes that are new. A tile's error is that of its patch's equations: it counts
/// where these have changed.
void LargeStepper::Pass::compute_residuals(bool first) {
    const auto has_changed = [](const LargeTile& tile) { return tile.state.equations_changed(); };
    for (const TilePlace& place : places)
        tile_of(place).state.enter_sweep(first || any_around(place, has_changed));
    const auto is_new = [](const LargeTile& tile) { return tile.state.change_is_new(); };
    const ChosenPlaces stale = places_where(
        [&](const TilePlace& place, const LargeTile&) { return any_around(place, is_new); });
    for_each_of(stale,
                [&](const TilePlace& place, LargeTile& tile, LargeScratch& large, WorkerScratch&) {
                    gather_next(place, cells(&LargeTile::change), large.change);
                    tile.state.note_error(
                        kernels.compute_residual(constants, place.columns.extent, place.rows.extent,
                                                 state.thickness.read(place.tile), large, tile));
                });
}

/// The tiles that have changed and have an error left; the first time all but those that only give and
/// take at their edges, where no wave runs whose error would look small. The slow ones, which take
/// longest, come first.
LargeStepper::Pass::ChosenPlaces LargeStepper::Pass::places_to_correct(bool first) {
    for (const TilePlace& place : places) {
        LargeTile& tile = tile_of(place);
        tile.state.choose_correction(first && !place.closed.inside, tolerance_of(tile));
    }
    ChosenPlaces chosen =
        places_where([](const TilePlace&, const LargeTile& tile) { return tile.state.is_corrected(); });
    std::stable_partition(chosen.begin(), chosen.end(),
                          [&](const TilePlace* place) { return tile_of(*place).state.is_slow(); });
    return chosen;
}

/// Solves the patches of the tiles that need it.
void LargeStepper::Pass::correct(bool first) {
    const auto solve_patch = [&](const TilePlace& place, LargeTile& tile, LargeScratch& large,
                                 WorkerScratch&) {
        gather_patch(place, cells(&LargeTile::residual), large.residual);
        gather_x_faces(place, &LargeFaces::mobility, large.mobility_x);
        gather_y_faces(place, &LargeFaces::mobility, large.mobility_y);
        gather_x_faces(place, &LargeFaces::weight, large.weight_x);
        gather_y_faces(place, &LargeFaces::weight, large.weight_y);
        kernels.correct_patch(constants, tile.state.is_slow() ? kMostCycles : 1,
                              patch_within_open_edges(place), large, tile.correction);
    };
    for_each_of(places_to_correct(first), solve_patch);
}

/// Adds the corrections to the pressure.
void LargeStepper::Pass::blend() {
    const auto is_corrected = [](const LargeTile& tile) { return tile.state.is_corrected(); };
    for (const TilePlace& place : places)
        tile_of(place).state.blend(any_around(place, is_corrected), has_rough_cover(place));
    const auto has_moved = [](const LargeTile& tile) { return tile.state.pressure_moved(); };
    for (const TilePlace& place : places) {
        LargeTileState& tile = tile_of(place).state;
        if (!tile.change_is_stale() && any_around(place, has_moved)) tile.join_moved();
    }
    const ChosenPlaces covered =
        places_where([&](const TilePlace&, const LargeTile& tile) { return has_moved(tile); });
    for_each_of(covered, [&](const TilePlace& place, LargeTile& tile, LargeScratch&, WorkerScratch&) {
        const std::vector<PatchCover> covers = patch_covers(place);
        kernels.blend(covers.data(), static_cast<int>(covers.size()), tile.pressure);
    });
}

/// Solves every tile's patch once, with the pressure that its neighbours had before; after the first
/// sweep only where there is an error left. Returns the largest relative error found on the way in. The
/// error of a smooth wave looks small to a cell, so that the first sweep is never spared.
float LargeStepper::Pass::sweep(bool first) {
    if (!first) answer_pressure();
    compute_residuals(first);
    correct(first);
    blend();
    return largest_error();
}

/// Sweeps until the error is small; `from_rest` when no pressure of this step is known yet.
void LargeStepper::Pass::solve(bool from_rest, LargeStepReport& report) {
    const auto is_done = [this](const TilePlace& place) {
        return is_close(*stepper.tiles_[place.tile]);
    };
    for (int count = 0; count < kMostSweeps; ++count) {
        report.residual = sweep(from_rest && count == 0);
        ++report.sweeps;
        if (std::all_of(places.begin(), places.end(), is_done)) return;
    }
}

/// Solves, and again with the drag of the flow found, until that no longer changes it: paint comes to
/// rest where its yield stress holds it.
void LargeStepper::Pass::solve_yielding(LargeStepReport& report) {
    solve(true, report);
    for (int pass = 0; pass < kMostCloseRefinements && refine_all(pass); ++pass)
        solve(false, report);
}

/// share = min(1, (held + sum of the donors' shares of the inflow) / outflow) of each cell: a fixed
/// point, reached from below, so that no pass takes a grant back. One pass of it, with the donors'
/// shares of `large`.
void LargeStepper::Pass::share_outflow(const TilePlace& place, LargeTile& tile, LargeScratch& large,
                                       CellArray& share) const {
    tile.shortage = kernels.share_outflow(constants, place.columns.extent, place.rows.extent,
                                          state.thickness.read(place.tile), large, tile, share);
}

/// The velocities that carry a tile's paint.
void LargeStepper::Pass::compute_velocities(const TilePlace& place, LargeTile& tile,
                                            LargeScratch& large) const {
    gather_next(place, cells(&LargeTile::pressure), large.pressure);
    kernels.velocities(constants, true, large, tile);
    tile.clamped_faces = 0;
    if (!tile.crowded) return;
    gather_next(place, thickness_rows(), large.thickness);
    tile.clamped_faces = kernels.cut_to_capacity(constants, large, tile);
}

/// How much of its outflow each cell can grant, counting on nothing from its neighbours: where the flow
/// is new, and where cells counted on neighbours whose flow may be new.
void LargeStepper::Pass::share_held() {
    const ChosenPlaces unknown = places_where([](const TilePlace&, const LargeTile& tile) {
        return tile.state.flow_is_stale() || tile.needs_inflow;
    });
    for_each_of(unknown,
                [&](const TilePlace& place, LargeTile& tile, LargeScratch& large, WorkerScratch&) {
                    if (tile.state.flow_is_stale()) {
                        compute_velocities(place, tile, large);
                        tile.state.note_flow();
                    }
                    large.share.fill(0.0F);
                    share_outflow(place, tile, large, tile.share);
                    tile.needs_inflow = tile.shortage.is_any;
                });
}

/// The same once more, counting on what the neighbours have granted so far.
void LargeStepper::Pass::share_inflow() {
    const ChosenPlaces limited =
        places_where([](const TilePlace&, const LargeTile& tile) { return tile.shortage.is_any; });
    for_each_of(limited,
                [&](const TilePlace& place, LargeTile& tile, LargeScratch& large, WorkerScratch&) {
                    gather_next(place, cells(&LargeTile::share), large.share);
                    share_outflow(place, tile, large, tile.next_share);
                });
    for_each_of(limited, [](const TilePlace&, LargeTile& tile, LargeScratch&, WorkerScratch&) {
        tile.share = tile.next_share;
    });
}

/// Whether more cells of a tile than these run empty.
bool LargeStepper::Pass::runs_short(int cells) const {
    return std::any_of(places.begin(), places.end(), [&](const TilePlace& place) {
        return tile_of(place).shortage.short_cells > cells;
    });
}

/// Takes mobility from the faces out of limited cells. Both tiles hold the same bits of the faces
/// between them.
void LargeStepper::Pass::slow_limited_faces() {
    const auto is_limited = [](const LargeTile* tile) {
        return tile != nullptr && tile->shortage.is_any;
    };
    const ChosenPlaces slowed = places_where([&](const TilePlace& place, const LargeTile& tile) {
        const std::array<LargeTile*, 4> neighbours = beside(place);
        return is_limited(&tile) || std::any_of(neighbours.begin(), neighbours.end(), is_limited);
    });
    for_each_of(slowed,
                [&](const TilePlace& place, LargeTile& tile, LargeScratch& large, WorkerScratch&) {
                    gather_next(place, cells(&LargeTile::share), large.share);
                    kernels.slow_limited_faces(constants, large, tile);
                    gather_next(place, cells(&LargeTile::pressure), large.pressure);
                    kernels.compute_change(large, tile);
                    tile.state.change_equations();
                });
}

/// Solves again, with less mobility out of the cells that would have run empty.
void LargeStepper::Pass::solve_within_supply(LargeStepReport& report) {
    for (int attempt = 0;; ++attempt) {
        share_held();
        for (int pass = 0; pass < kMostSharePasses && runs_short(0); ++pass)
            share_inflow();
        if (!runs_short(kFewShortCells) || attempt == kMostSlowings) break;
        slow_limited_faces();
        solve(false, report);
    }
    for (const TilePlace& place : places) {
        report.limited_cells += tile_of(place).shortage.thick_short_cells;
        report.clamped_faces += tile_of(place).clamped_faces;
    }
}

std::vector<TileResult> LargeStepper::Pass::finish() {
    std::vector<TileResult> results(places.size());
    for_each_tile([&](std::size_t index, LargeTile& tile, LargeScratch& large, WorkerScratch& worker) {
        const TilePlace& place = places[index];
        gather_quanta(state.thickness, place.columns, place.rows, place.tile_x,
                      worker.tile.block.quanta);
        gather_next(place, cells(&LargeTile::share), large.share);
        if (!place.closed.inside)
            stepper.last_pressures_[place.tile] = grid::TileBlock<float>::copy_of(tile.pressure.data());
        worker.tile.large_fluxes = true;
        gather_window(columns(place).next_cells, rows(place).next_cells, kTileSize + 2, kBlockStride,
                      cells(&LargeTile::supply), &worker.tile.supply[block_index(-1, -1)]);
        const FlowExtremes extremes = kernels.fluxes(constants, large, tile, worker.tile);
        results[index] = collect_tile(state, place, constants, extremes, worker);
    });
    return results;
}

namespace {

/// Turns the velocities of the film that passed the faces into those of the new mean thickness there;
/// the other cell lies `along` further in the block.
void settle_faces(const HaloBlock& block, int along, const LargeFaces& faces, float* velocity) {
    for (int y = 0; y < kTileSize; ++y)
        for (int x = 0; x < kTileSize; ++x) {
            const int f = face_index(x, y), i = block_index(x, y);
            if (faces.drag[f] < 0.0F || faces.drag[f] >= kInertialDrag) continue;
            const float mean_mm =
                0.5F * (thickness_mm(block.quanta[i]) + thickness_mm(block.quanta[i + along]));
            velocity[y * kTileSize + x] *= settled_share(faces.depth[f], mean_mm);
        }
}

}  // namespace

void LargeStepper::settle(FilmState& state, const std::vector<TilePlace>& places, core::ThreadPool& pool,
                          std::vector<std::unique_ptr<WorkerScratch>>& workers) const {
    pool.run(places.size(), [&](std::size_t index, int worker) {
        const TilePlace& place = places[index];
        const LargeTile* tile = tiles_[place.tile];
        if (tile == nullptr || !tile->inertial) return;
        HaloBlock& block = workers[worker]->tile.block;
        gather_quanta(state.thickness, place.columns, place.rows, place.tile_x, block.quanta);
        settle_faces(block, 1, tile->x, state.velocity_x.write(place.tile));
        settle_faces(block, kBlockStride, tile->y, state.velocity_y.write(place.tile));
    });
}

LargeStepper::LargeStepper(grid::Shape shape, Edge edge_x, Edge edge_y, int thread_count)
    : edge_x_(edge_x),
      edge_y_(edge_y),
      last_pressures_(shape.tile_count()),
      tiles_(shape.tile_count(), nullptr) {
    for (int x = 0; x < shape.tiles_x(); ++x)
        columns_.push_back({window_runs(x, shape.width, edge_x, 1),
                            window_runs(x, shape.width, edge_x, kWindowMargin),
                            covering_runs(x, shape.width, edge_x, kOverlap)});
    for (int y = 0; y < shape.tiles_y(); ++y)
        rows_.push_back({window_runs(y, shape.height, edge_y, 1),
                         window_runs(y, shape.height, edge_y, kWindowMargin),
                         covering_runs(y, shape.height, edge_y, kOverlap)});
    for (int worker = 0; worker < thread_count; ++worker)
        scratch_.push_back(std::make_unique<LargeScratch>());
}

void LargeStepper::forget(int tile) {
    last_pressures_[tile] = {};
    tiles_[tile] = nullptr;
}

void LargeStepper::lend_tiles(const std::vector<TilePlace>& places) {
    std::fill(tiles_.begin(), tiles_.end(), nullptr);
    lately_needed_ = std::max(static_cast<double>(places.size()), lately_needed_ * kStillNeeded);
    if (static_cast<double>(spare_tiles_.size()) > 2.0 * lately_needed_)
        spare_tiles_.resize(static_cast<std::size_t>(lately_needed_));
    while (spare_tiles_.size() < places.size())
        spare_tiles_.push_back(std::make_unique<LargeTile>());
    for (std::size_t index = 0; index < places.size(); ++index)
        tiles_[places[index].tile] = spare_tiles_[index].get();
}

std::vector<TileResult> LargeStepper::step(const FilmState& state, const std::vector<TilePlace>& places,
                                           const StepConstants& step, core::ThreadPool& pool,
                                           std::vector<std::unique_ptr<WorkerScratch>>& workers,
                                           bool accept_any, LargeStepReport& report) {
    lend_tiles(places);
    const auto is_usable = [&] { return report.residual <= kUsable || accept_any; };
    Pass pass{*this, state, places, step, pool, workers};
    report = {};
    pass.assemble_all();
    report.draws_back = !accept_any && pass.draws_back_too_far();
    if (report.draws_back) return {};
    pass.solve_yielding(report);
    if (!is_usable()) return {};
    pass.solve_within_supply(report);
    if (!is_usable()) return {};
    return pass.finish();
}

}  // namespace pastoso::film

#include "document/living_painting.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::document {
namespace {

constexpr const char* kFirstMedium = "heavy-body oil";

PaintingValue bare_painting(const CanvasSettings& settings, film::SupportHeights support_mm) {
    PaintingValue painting{.bare = std::make_shared<const BareCanvas>(BareCanvas{settings, support_mm}),
                           .film = {canvas_shape(settings), 1.0 / settings.px_per_mm},
                           .medium = {kFirstMedium}};
    PASTOSO_CHECK(support_mm.shape() == painting.film.shape);
    painting.film.support_mm = std::move(support_mm);
    return painting;
}

brush::Contents positive_part(const brush::Contents& contents, double sign) {
    brush::Contents part;
    part.volume_mm3 = std::max(0.0, sign * contents.volume_mm3);
    for (int k = 0; k < film::kPaintChannels; ++k)
        part.paint[k] = std::max(0.0, sign * contents.paint[k]);
    return part;
}

}  // namespace

LivingPainting::LivingPainting(const CanvasSettings& settings, film::SupportHeights support_mm,
                               core::ThreadPool& threads)
    : value(bare_painting(settings, std::move(support_mm))),
      pool(threads),
      medium(medium_of(value.medium)),
      canvas(value, medium, threads) {
    canvas.solver.set_gravity(film::tilted_gravity(0.0));
}

LivingPainting::LivingPainting(const PaintingState& state, core::ThreadPool& threads)
    : value(state.value),
      pool(threads),
      medium(medium_of(value.medium)),
      canvas(value, medium, threads),
      tick(state.tick) {
    PASTOSO_CHECK(value.film.shape == canvas_shape(value.bare->settings));
    ageing.restore(state.ageing);
    canvas.solver.set_gravity(film::tilted_gravity(value.tilt.tilt_deg, value.tilt.direction_deg));
    canvas.solver.set_cover(value.masking.cells);
    canvas.solver.restore(state.solver);
    if (!value.well) return;
    PASTOSO_CHECK(value.well->shape == bare_well().shape);
    make_well_solver().restore(state.well_solver);
}

PaintingState LivingPainting::state() const {
    PASTOSO_CHECK(!stroke);
    return {.value = value,
            .solver = canvas.solver.state(),
            .well_solver = well_solver ? well_solver->state() : film::SolverState{},
            .ageing = ageing.pending(),
            .tick = tick};
}

Moment LivingPainting::moment() const {
    return {.value = value,
            .awake = canvas.solver.awake_tiles(),
            .well_awake = well_solver ? well_solver->awake_tiles() : std::vector<bool>{},
            .run_off = run_off()};
}

void LivingPainting::begin_stroke_on(Surface surface) {
    if (surface == Surface::Canvas) {
        share_consistencies();
        touched = &canvas.solver;
        stroke_limit = within_reach();
        stroke.emplace(value.brush->brush, value.film, value.aids, value.symmetry, stroke_limit.get(),
                       &pool);
    } else {
        touched = &used_well();
        stroke.emplace(value.brush->brush, *value.well, brush::HandAids{value.aids.stabiliser, {}},
                       brush::Symmetry{}, nullptr, &pool);
    }
}

void LivingPainting::end_stroke() {
    if (!stroke) return;
    stroke->end();
    value.flows.wiped += stroke->copied_paint();
    finish_contacts();
    stroke.reset();
    begun.reset();
    awaited_step.reset();
}

void LivingPainting::mask(Masking masking) {
    value.masking = std::move(masking);
    canvas.solver.set_cover(value.masking.cells);
}

const Selection& LivingPainting::unmasked() {
    if (unmasked_.selection != value.selection || unmasked_.masking != value.masking)
        unmasked_ = {value.selection, value.masking, without_masked(value.selection, value.masking)};
    return unmasked_.cells;
}

Selection LivingPainting::within_reach() {
    const Selection& free = unmasked();
    if (!effective_look(value.layers, value.layers.active).bare_locked) return free;
    grid::Mask painted = area_of(SelectPaint{}, value.film, canvas.base_mm());
    return std::make_shared<const grid::Mask>(
        free ? grid::combined(painted, *free, Combination::Intersect) : std::move(painted));
}

void LivingPainting::finish_contacts() {
    bool touches = false;
    for (const grid::Rect& cells : stroke->take_changed_cells()) {
        touched->wake(cells);
        touches = touches || !cells.empty();
    }
    const film::FilmState& film = begun->surface == Surface::Well ? *value.well : value.film;
    const std::vector<film::AirJet> jets = stroke->air_jets();
    for (const film::AirJet& jet : jets)
        touches = touches || !film::cells_reached(jet, film.shape, film.cell_mm).empty();
    touched->set_air(jets);
    value.flows.wiped += stroke->take_thrown_away();
    if (touches) remember_awaited_step();
}

void LivingPainting::remember_awaited_step() {
    if (!awaited_step) return;
    history.remember(std::move(awaited_step->before), std::move(awaited_step->step));
    awaited_step.reset();
    ++late_strokes;
}

void LivingPainting::touch_brush() {
    if (value.brush) value.brush->touch = ++brush_touches;
}

film::Solver& LivingPainting::used_well() {
    if (!value.well) value.well = bare_well();
    if (!well_solver) value.well->consistencies.add(make_well_solver().consistency());
    share_consistencies();
    return *well_solver;
}

film::Solver& LivingPainting::make_well_solver() {
    well_solver.emplace(*value.well, medium, kWellSolving, pool);
    well_solver->set_gravity(film::tilted_gravity(0.0));
    return *well_solver;
}

void LivingPainting::share_consistencies() {
    if (!value.well) return;
    value.film.consistencies.add(value.well->consistencies);
    value.well->consistencies = value.film.consistencies;
}

void LivingPainting::book(const LayerChange& paint) {
    book(contents_of(paint.before), contents_of(paint.after));
}

void LivingPainting::book(const brush::Contents& before, const brush::Contents& after) {
    brush::Contents gained = after;
    gained -= before;
    value.flows.taken += positive_part(gained, 1.0);
    value.flows.wiped += positive_part(gained, -1.0);
}

void LivingPainting::forget_run_off() {
    value.flows.wiped += document::contents_of(run_off(), value.film.cell_mm);
    value.flows.forgotten_run_off = canvas.solver.runoff();
}

brush::Contents LivingPainting::contents_of(const LayerPaint& paint) const {
    const double cell_mm = value.film.cell_mm;
    brush::Contents sum = document::contents_of(paint.wet, cell_mm);
    sum += document::contents_of(paint.dried, cell_mm);
    sum.volume_mm3 += film::volume_mm3(paint.evaporated, cell_mm);
    return sum;
}

brush::Contents LivingPainting::held_paint() const {
    brush::Contents sum = value.brush ? value.brush->brush.contents() : brush::Contents{};
    if (value.brush_aside) sum += value.brush_aside->brush.contents();
    if (stroke) sum += stroke->copied_paint();
    return sum;
}

brush::Contents LivingPainting::paint_in_well() const {
    return value.well ? document::contents_of(film::totals(*value.well), value.well->cell_mm)
                      : brush::Contents{};
}

void LivingPainting::finish_tick(film::AdvanceReport flow) {
    if (well_solver) {
        const int awake_tiles = flow.awake_tiles;
        flow.add(well_solver->advance(kTick_s));
        flow.awake_tiles += awake_tiles;
    }
    film_report.add(flow);
    age();
    ++tick;
}

void LivingPainting::age() {
    ageing.tick(kTick_s, value.air, value.film, pool, value.masking.cells.get());
    if (!stroke) return;
    stroke->pass_time(kTick_s);
    finish_contacts();
}

const std::shared_ptr<const LayerStack>& LivingPainting::shared_layers() {
    if (!layers_shown || *layers_shown != value.layers)
        layers_shown = std::make_shared<const LayerStack>(value.layers);
    return layers_shown;
}

}  // namespace pastoso::document

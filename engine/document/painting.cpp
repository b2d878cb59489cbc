#include "document/painting.hpp"

#include "core/check.hpp"
#include "core/hash.hpp"
#include "core/memory.hpp"
#include "document/action_checks.hpp"
#include "document/canvas.hpp"
#include "document/painting_parts.hpp"

#include <chrono>
#include <utility>

namespace pastoso::document {
namespace {

constexpr const char* kFirstMedium = "heavy-body oil";

film::SupportHeights support_by_name(const CanvasSettings& settings, core::ThreadPool& pool) {
    check_canvas_fits(settings, core::available_memory_bytes());
    return named_support(settings, pool);
}

film::FilmState bare_canvas(const CanvasSettings& settings, film::SupportHeights support_mm) {
    film::FilmState film(canvas_shape(settings), 1.0 / settings.px_per_mm);
    PASTOSO_CHECK(support_mm.shape() == film.shape);
    film.support_mm = std::move(support_mm);
    return film;
}

std::uint64_t hash_of(std::uint64_t alone, const film::FilmState* well) {
    if (well == nullptr) return alone;
    core::Hash64 both;
    both.add_value(alone);
    both.add_value(film::state_hash(*well));
    return both.value();
}

brush::Brush brush_of(const BrushState& state) {
    brush::Brush brush(preset_of(state.taken), state.taken.size_mm, state.taken.seed);
    PASTOSO_CHECK_OP(brush.held.size(), ==, state.held.size());
    brush.held = state.held;
    brush.strokes_begun = state.strokes_begun;
    return brush;
}

/// Adds the time until the end of the scope to a sum.
class ScopedTimer {
  public:
    explicit ScopedTimer(double& sum_s) : sum_s_(sum_s) {}
    ~ScopedTimer() { sum_s_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
    ScopedTimer(const ScopedTimer&) = delete;
    ScopedTimer& operator=(const ScopedTimer&) = delete;

  private:
    using Clock = std::chrono::steady_clock;
    double& sum_s_;
    Clock::time_point start_ = Clock::now();
};

}  // namespace

Painting::Parts::Parts(const CanvasSettings& wanted, film::SupportHeights support_mm,
                       core::ThreadPool& threads)
    : bare(std::make_shared<const BareCanvas>(BareCanvas{wanted, support_mm})),
      pool(threads),
      used_medium{kFirstMedium},
      medium(medium_of(used_medium)),
      canvas(bare_canvas(wanted, std::move(support_mm)), medium, threads) {
    solver.set_gravity(film::tilted_gravity(0.0));
}

Painting::Parts::Parts(const PaintingState& state, core::ThreadPool& threads)
    : bare(std::make_shared<const BareCanvas>(BareCanvas{state.settings, state.bare_support_mm})),
      pool(threads),
      used_medium(state.medium),
      medium(medium_of(used_medium)),
      canvas(state.canvas.film, state.bare_support_mm, state.layers, medium, threads),
      tilt(state.tilt),
      air(state.air),
      aids(state.aids),
      symmetry(state.symmetry),
      selection(state.selection),
      tracing(state.tracing),
      taken(state.taken),
      wiped(state.wiped),
      forgotten_run_off(state.forgotten_run_off),
      tick(state.tick) {
    PASTOSO_CHECK(film.shape == canvas_shape(bare->settings));
    ageing.restore(state.ageing);
    if (state.brush) {
        brush = brush_of(*state.brush);
        taken_brush = state.brush->taken;
    }
    solver.set_gravity(film::tilted_gravity(tilt.tilt_deg, tilt.direction_deg));
    solver.restore(state.canvas.solver);
    if (!state.well) return;
    well = std::make_unique<Well>(medium, pool);
    PASTOSO_CHECK(well->film.shape == state.well->film.shape);
    well->film = state.well->film;
    well->solver.restore(state.well->solver);
}

PaintingState Painting::Parts::state() const {
    PASTOSO_CHECK(!stroke);
    PaintingState state{.settings = bare->settings,
                        .tick = tick,
                        .canvas = {film, solver.state()},
                        .layers = canvas.stack(),
                        .bare_support_mm = canvas.bare_mm(),
                        .medium = used_medium,
                        .tilt = tilt,
                        .air = air,
                        .ageing = ageing.pending(),
                        .aids = aids,
                        .symmetry = symmetry,
                        .selection = selection,
                        .tracing = tracing,
                        .taken = taken,
                        .wiped = wiped,
                        .forgotten_run_off = forgotten_run_off};
    if (well) state.well = SurfaceState{well->film, well->solver.state()};
    if (brush) state.brush = BrushState{taken_brush, brush->held, brush->strokes_begun};
    return state;
}

Painting::Painting(const CanvasSettings& settings, core::ThreadPool& pool)
    : Painting(settings, support_by_name(settings, pool), pool) {}

Painting::Painting(const CanvasSettings& settings, film::SupportHeights support_mm,
                   core::ThreadPool& pool)
    : parts_(std::make_unique<Parts>(settings, std::move(support_mm), pool)) {}

Painting::Painting(const PaintingState& state, core::ThreadPool& pool)
    : parts_(std::make_unique<Parts>(state, pool)) {}

Painting::~Painting() = default;

void Painting::apply(const Action& action) {
    check_action(action);
    const ScopedTimer timer(parts_->times.brush_s);
    std::visit(*parts_, action);
}

void Painting::advance_tick() {
    const ScopedTimer timer(parts_->times.film_s);
    parts_->finish_tick(parts_->solver.advance(kTick_s));
}

bool Painting::advance_tick_unless(const std::function<bool()>& give_up) {
    const ScopedTimer timer(parts_->times.film_s);
    const auto report = parts_->solver.advance_unless(give_up, kTick_s);
    if (!report) return false;
    parts_->finish_tick(*report);
    return true;
}

void Painting::set_history_budget(std::size_t bytes) {
    parts_->history.set_budget(bytes);
}

void Painting::keep_undo_steps(std::size_t count) {
    parts_->history.keep_steps(count);
}

std::int64_t Painting::tick() const {
    return parts_->tick;
}
const CanvasSettings& Painting::settings() const {
    return parts_->bare->settings;
}
const film::FilmState& Painting::film() const {
    return parts_->film;
}
const LayerStack& Painting::layers() const {
    return parts_->canvas.stack();
}
const film::FilmState* Painting::well() const {
    return parts_->well ? &parts_->well->film : nullptr;
}
Snapshot Painting::snapshot() const {
    return {parts_->canvas.view(),
            kPrimedGround,
            parts_->tick,
            parts_->well_film(),
            parts_->brush ? brush::load_profile(*parts_->brush) : brush::LoadProfile{},
            parts_->shared_layers(),
            is_single(layers()) ? nullptr : std::make_shared<const film::FilmState>(film()),
            parts_->selection,
            parts_->bare,
            parts_->tracing};
}
bool Painting::can_undo() const {
    return parts_->history.can_undo();
}
bool Painting::can_redo() const {
    return parts_->history.can_redo();
}
std::vector<KeptStep> Painting::undo_steps() const {
    return parts_->history.past_steps();
}
std::vector<KeptStep> Painting::redo_steps() const {
    return parts_->history.future_steps();
}
bool Painting::stroke_in_progress() const {
    return parts_->stroke.has_value();
}

Account Painting::account() const {
    const double cell_mm = parts_->film.cell_mm;
    const LayerPaint paint = parts_->canvas.paint();
    brush::Contents ledger = parts_->wiped;
    ledger += contents_of(parts_->run_off(), cell_mm);
    ledger.volume_mm3 += film::volume_mm3(paint.evaporated, cell_mm);
    return {amount(parts_->taken),
            amount(contents_of(paint.wet, cell_mm)),
            amount(contents_of(paint.dried, cell_mm)),
            amount(parts_->held_paint()),
            amount(ledger),
            amount(parts_->paint_in_well())};
}

StageTimes Painting::stage_times() const {
    return parts_->times;
}
film::AdvanceReport Painting::film_report() const {
    return parts_->film_report;
}
PaintingState Painting::state() const {
    return parts_->state();
}
std::uint64_t Painting::state_hash() const {
    return hash_of(parts_->canvas.state_hash(), well());
}

std::uint64_t state_hash(const PaintingState& state) {
    return hash_of(state_hash(state.canvas.film, state.layers),
                   state.well ? &state.well->film : nullptr);
}

}  // namespace pastoso::document

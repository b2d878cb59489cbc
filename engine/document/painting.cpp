#include "document/painting.hpp"

#include "core/hash.hpp"
#include "core/memory.hpp"
#include "document/actions/perform.hpp"
#include "document/canvas.hpp"
#include "document/cloth.hpp"
#include "document/living_painting.hpp"

#include <chrono>
#include <utility>

namespace pastoso::document {
namespace {

film::SupportHeights support_by_name(const CanvasSettings& settings, core::ThreadPool& pool) {
    check_canvas_fits(settings, core::available_memory_bytes());
    return heights_of_cloth(settings, pool);
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

Painting::Painting(const CanvasSettings& settings, core::ThreadPool& pool)
    : Painting(settings, support_by_name(settings, pool), pool) {}

Painting::Painting(const CanvasSettings& settings, film::SupportHeights support_mm,
                   core::ThreadPool& pool)
    : living_(std::make_unique<LivingPainting>(settings, std::move(support_mm), pool)) {}

Painting::Painting(const PaintingState& state, core::ThreadPool& pool)
    : living_(std::make_unique<LivingPainting>(state, pool)) {}

Painting::~Painting() = default;

void Painting::apply(const Action& action) {
    check_action(action);
    const ScopedTimer timer(living_->times.brush_s);
    std::visit([&](const auto& one) { perform(one, *living_); }, action);
}

void Painting::have_ready(ResizedCanvas canvas) {
    living_->ready_canvas = std::move(canvas);
}

void Painting::advance_tick() {
    const ScopedTimer timer(living_->times.film_s);
    living_->finish_tick(living_->canvas.solver.advance(kTick_s));
}

bool Painting::advance_tick_unless(const std::function<bool()>& cancelled) {
    const ScopedTimer timer(living_->times.film_s);
    const auto report = living_->canvas.solver.advance_unless(cancelled, kTick_s);
    if (!report) return false;
    living_->finish_tick(*report);
    return true;
}

void Painting::set_history_budget(std::size_t bytes) {
    living_->history.set_budget(bytes);
}

void Painting::keep_undo_steps(std::size_t count) {
    living_->history.keep_steps(count);
}

std::int64_t Painting::tick() const {
    return living_->tick;
}
const CanvasSettings& Painting::settings() const {
    return living_->value.bare->settings;
}
const film::FilmState& Painting::film() const {
    return living_->value.film;
}
const LayerStack& Painting::layers() const {
    return living_->value.layers;
}
const film::FilmState* Painting::well() const {
    return living_->value.well ? &*living_->value.well : nullptr;
}
Snapshot Painting::snapshot() const {
    const PaintingValue& value = living_->value;
    const bool single = is_single(value.layers);
    return {.film = living_->canvas.view(),
            .ground = kPrimedGround,
            .tick = living_->tick,
            .well = value.well,
            .brush_load = value.brush ? brush::load_profile(value.brush->brush) : brush::LoadProfile{},
            .layers = living_->shared_layers(),
            .active = single ? nullptr : std::make_shared<const film::FilmState>(value.film),
            .selection = value.selection,
            .masking = value.masking,
            .bare = value.bare,
            .tracing = value.tracing,
            .references = value.references,
            .copied = value.copied};
}
bool Painting::can_undo() const {
    return living_->history.can_undo();
}
bool Painting::can_redo() const {
    return living_->history.can_redo();
}
std::vector<KeptStep> Painting::undo_steps() const {
    return living_->history.past_steps();
}
std::vector<KeptStep> Painting::redo_steps() const {
    return living_->history.future_steps();
}
bool Painting::stroke_in_progress() const {
    return living_->stroke.has_value();
}
std::int64_t Painting::late_strokes() const {
    return living_->late_strokes;
}

Account Painting::account() const {
    const double cell_mm = living_->value.film.cell_mm;
    const LayerPaint paint = living_->canvas.paint();
    brush::Contents ledger = living_->value.flows.wiped;
    ledger += contents_of(living_->run_off(), cell_mm);
    ledger.volume_mm3 += film::volume_mm3(paint.evaporated, cell_mm);
    return {amount(living_->value.flows.taken),
            amount(contents_of(paint.wet, cell_mm)),
            amount(contents_of(paint.dried, cell_mm)),
            amount(living_->held_paint()),
            amount(ledger),
            amount(living_->paint_in_well())};
}

StageTimes Painting::stage_times() const {
    return living_->times;
}
film::AdvanceReport Painting::film_report() const {
    return living_->film_report;
}
PaintingState Painting::state() const {
    return living_->state();
}
std::uint64_t Painting::state_hash() const {
    return document::state_hash(living_->value);
}

std::uint64_t state_hash(const PaintingValue& value) {
    const std::uint64_t canvas = state_hash(value.film, value.layers);
    if (!value.well) return canvas;
    core::Hash64 both;
    both.add_value(canvas);
    both.add_value(film::state_hash(*value.well));
    return both.value();
}

}  // namespace pastoso::document

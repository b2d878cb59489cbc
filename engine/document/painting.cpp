#include "document/painting.hpp"

#include "brush/brush.hpp"
#include "brush/stroke_group.hpp"
#include "core/check.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "document/action_checks.hpp"
#include "document/canvas.hpp"
#include "document/contents.hpp"
#include "document/history.hpp"
#include "document/layered_canvas.hpp"
#include "document/paint_mixing.hpp"
#include "document/painting_state.hpp"
#include "document/well.hpp"
#include "film/ageing.hpp"
#include "film/solver_memory.hpp"
#include "film/support.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

namespace pastoso::document {
namespace {

constexpr const char* kFirstMedium = "heavy-body oil";

film::SupportHeights support_by_name(const CanvasSettings& settings, core::ThreadPool& pool) {
    check_canvas_fits(settings, available_memory_bytes());
    return film::named_support(settings.support, canvas_shape(settings), 1.0 / settings.px_per_mm,
                               settings.support_relief_mm, pool);
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

film::Totals difference(film::Totals a, const film::Totals& b) {
    a.thickness -= b.thickness;
    for (int k = 0; k < film::kPaintChannels; ++k)
        a.paint[k] -= b.paint[k];
    return a;
}

brush::Contents positive_part(const brush::Contents& contents, double sign) {
    brush::Contents part;
    part.volume_mm3 = std::max(0.0, sign * contents.volume_mm3);
    for (int k = 0; k < film::kPaintChannels; ++k)
        part.paint[k] = std::max(0.0, sign * contents.paint[k]);
    return part;
}

const char* no_brush_for(Surface surface) {
    return surface == Surface::Canvas ? "the pen touches the canvas with no brush in hand."
                                      : "the pen touches the mixing well with no brush in hand.";
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

/// Applies actions by std::visit; the actions have passed check_action().
struct Painting::Parts {
    Parts(const CanvasSettings& wanted, film::SupportHeights support_mm, core::ThreadPool& threads)
        : settings(wanted),
          pool(threads),
          medium(film::find_medium(kFirstMedium)),
          canvas(bare_canvas(wanted, std::move(support_mm)), medium, threads) {
        solver.set_gravity(film::tilted_gravity(0.0));
    }

    /// The solvers' memories come last: whatever else is set wakes paint.
    Parts(const PaintingState& state, core::ThreadPool& threads)
        : settings(state.settings),
          pool(threads),
          medium(film::find_medium(state.medium)),
          canvas(state.canvas.film, state.bare_support_mm, state.layers, medium, threads),
          tilt(state.tilt),
          air(state.air),
          aids(state.aids),
          symmetry(state.symmetry),
          selection(state.selection),
          taken(state.taken),
          wiped(state.wiped),
          forgotten_run_off(state.forgotten_run_off),
          tick(state.tick) {
        PASTOSO_CHECK(film.shape == canvas_shape(settings));
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

    PaintingState state() const {
        PASTOSO_CHECK(!stroke);
        PaintingState state{.settings = settings,
                            .tick = tick,
                            .canvas = {film, solver.memory()},
                            .layers = canvas.stack(),
                            .bare_support_mm = canvas.bare_mm(),
                            .medium = medium.name,
                            .tilt = tilt,
                            .air = air,
                            .ageing = ageing.pending(),
                            .aids = aids,
                            .symmetry = symmetry,
                            .selection = selection,
                            .taken = taken,
                            .wiped = wiped,
                            .forgotten_run_off = forgotten_run_off};
        if (well) state.well = SurfaceState{well->film, well->solver.memory()};
        if (brush) state.brush = BrushState{taken_brush, brush->held, brush->strokes_begun};
        return state;
    }

    void operator()(const TakeBrush& take) {
        brush::Brush fresh(preset_of(take), take.size_mm, take.seed);
        end_stroke();
        wipe_brush();
        brush = std::move(fresh);
        taken_brush = take;
    }

    void operator()(const LoadPaint& load) {
        if (!brush) throw core::InputError("there is no brush in hand to take paint with.");
        end_stroke();
        brush::MixedLoad paint{.first = mixed_paint(load.paint, medium), .tip_only = load.tip_only};
        if (!load.second.ingredients.empty()) {
            paint.second = mixed_paint(load.second, medium);
            paint.second_share = load.second_share;
            paint.share_variation = load.share_variation;
            paint.side_by_side = load.side_by_side;
        }
        taken += brush->load(paint, load.fill);
        ++brush_use;
    }

    void operator()(const CleanBrush& clean) {
        end_stroke();
        wipe_brush(clean.share);
    }

    void operator()(const UseMedium& use) {
        const film::Medium& next = film::find_medium(use.name);
        if (next.name != medium.name) {
            film.varied = film::has_wet_paint(film) || brush_holds_paint() || well;
            if (well) well->film.varied = true;
        }
        medium = next;
        solver.set_medium(medium);
        if (well) well->solver.set_medium(medium);
    }
    void operator()(const TiltCanvas& wanted) {
        tilt = wanted;
        solver.set_gravity(film::tilted_gravity(tilt.tilt_deg, tilt.direction_deg));
    }

    void operator()(const SetDrying& drying) { air = drying.air; }

    void operator()(const DryNow&) {
        check_unlocked(canvas.stack(), canvas.stack().active);
        end_stroke();
        history.remember(moment(), {Step::Kind::DryNow, {}, active_name()});
        film::dry_now(film, pool, selection.get());
    }

    void operator()(const PenDown& pen) {
        if (!brush) throw core::InputError(no_brush_for(pen.surface));
        if (pen.surface == Surface::Canvas) check_paintable(canvas.stack(), canvas.stack().active);
        end_stroke();
        history.remember(moment(), stroke_step(pen.surface));
        last_sample = pen.sample;
        begin_stroke_on(pen.surface);
        taken += stroke->copied_paint();
        stroke->begin(pen.sample);
        hand_over();
    }

    void operator()(const PenMove& pen) {
        if (!stroke) return;
        check_time_order(last_sample, pen.sample);
        last_sample = pen.sample;
        stroke->add(pen.sample);
        hand_over();
    }

    void operator()(const PenUp&) { end_stroke(); }

    void operator()(const Undo&) {
        end_stroke();
        if (history.can_undo()) return_to(history.step_back(moment()));
    }

    void operator()(const Redo&) {
        end_stroke();
        if (history.can_redo()) return_to(history.step_forward(moment()));
    }

    void operator()(const SqueezePaint& squeeze) {
        end_stroke();
        history.remember(moment(), {Step::Kind::SqueezePaint});
        const film::PaintCoefficients paint = mixed_paint(squeeze.paint, medium);
        taken += squeeze_onto(used_well(), paint, squeeze.volume_mm3, squeeze.x_mm, squeeze.y_mm);
    }

    void operator()(const CleanWell&) {
        end_stroke();
        if (!well) return;
        history.remember(moment(), {Step::Kind::CleanWell});
        wiped += paint_in_well();
        well.reset();
    }

    void operator()(const SelectArea& area) { select(area_of(area, film), area.how); }
    void operator()(const SelectByHeight& heights) {
        end_stroke();
        select(area_of(heights, film, canvas.bare_mm()), heights.how);
    }
    void operator()(const SelectByWetness& wetness) {
        end_stroke();
        select(area_of(wetness, film), wetness.how);
    }
    void operator()(const InvertSelection&) {
        if (selection) replace_selection(inverted(selection));
    }
    void operator()(const SelectAll&) {
        if (selection) replace_selection(nullptr);
    }

    void operator()(const SelectLayer& select) {
        end_stroke();
        canvas.select(select);
    }
    void operator()(const AddLayer& add) {
        change_layers({Step::Kind::AddLayer, {}, add.name}, [&] { canvas.add(add); });
    }
    void operator()(const PaintPicture& paint) {
        change_layers({Step::Kind::PaintPicture, {}, paint.name},
                      [&] { taken += contents_of(canvas.paint_picture(paint)); });
    }
    void operator()(const SetLayer& set) {
        change_layers(layer_step(Step::Kind::SetLayer, set.layer), [&] { canvas.set(set); });
    }
    void operator()(const SetGroup& set) {
        change_layers(group_step(Step::Kind::SetGroup, set.group), [&] { canvas.set_group(set); });
    }
    void operator()(const MoveLayer& move) {
        change_layers(layer_step(Step::Kind::MoveLayer, move.layer), [&] { canvas.move(move); });
    }
    void operator()(const MoveGroup& move) {
        change_layers(group_step(Step::Kind::MoveGroup, move.group), [&] { canvas.move_group(move); });
    }
    void operator()(const GroupLayers& group) {
        change_layers({Step::Kind::GroupLayers, {}, group.name}, [&] { canvas.group(group); });
    }
    void operator()(const UngroupLayers& ungroup) {
        change_layers(group_step(Step::Kind::UngroupLayers, ungroup.group),
                      [&] { canvas.ungroup(ungroup); });
    }
    void operator()(const MergeDown& merge) {
        change_layers(layer_step(Step::Kind::MergeDown, merge.layer), [&] { canvas.merge_down(merge); });
    }
    void operator()(const FlattenLayers&) {
        change_layers({Step::Kind::FlattenLayers}, [&] { canvas.flatten(); });
    }
    void operator()(const DuplicateLayer& duplicate) {
        change_layers(layer_step(Step::Kind::DuplicateLayer, duplicate.layer),
                      [&] { taken += contents_of(canvas.duplicate(duplicate)); });
    }
    void operator()(const RemoveLayer& remove) {
        change_layers(layer_step(Step::Kind::RemoveLayer, remove.layer),
                      [&] { wiped += contents_of(canvas.remove(remove)); });
    }
    void operator()(const ClearLayer& clear) {
        change_layers(layer_step(Step::Kind::ClearLayer, clear.layer),
                      [&] { wiped += contents_of(canvas.clear(clear, selection.get())); });
    }

    void operator()(const TransformLayer& transform) {
        change_layers(layer_step(Step::Kind::TransformLayer, transform.layer), [&] {
            book(canvas.transform(transform, selection.get()));
            selection = transformed(selection, film.cell_mm, transform.transform);
        });
    }

    /// What there is more of came out of the tubes, what there is less of was wiped off.
    void book(const LayerChange& paint) {
        brush::Contents gained = contents_of(paint.after);
        gained -= contents_of(paint.before);
        taken += positive_part(gained, 1.0);
        wiped += positive_part(gained, -1.0);
    }

    /// A change that cannot be made leaves all as it was.
    template <class Change>
    void change_layers(Step step, const Change& change) {
        end_stroke();
        Moment before = moment();
        change();
        history.remember(std::move(before), std::move(step));
    }

    brush::Contents contents_of(const LayerPaint& paint) const {
        brush::Contents sum = document::contents_of(paint.wet, film.cell_mm);
        sum += document::contents_of(paint.dried, film.cell_mm);
        sum.volume_mm3 += film::volume_mm3(paint.evaporated, film.cell_mm);
        return sum;
    }

    void operator()(const SetStabiliser& set) { aids.stabiliser = set.stabiliser; }
    void operator()(const SetGuide& set) { aids.guide = set.guide; }
    void operator()(const SetSymmetry& set) { symmetry = set.symmetry; }

    /// Guides and symmetries lie on the canvas; in the well the hand is free.
    void begin_stroke_on(Surface surface) {
        if (surface == Surface::Canvas) {
            share_varied();
            touched = &solver;
            stroke.emplace(*brush, film, aids, symmetry, selection.get());
        } else {
            touched = &used_well().solver;
            stroke.emplace(*brush, well->film, brush::HandAids{aids.stabiliser, {}}, brush::Symmetry{});
        }
    }

    void select(const grid::Mask& area, Combination how) {
        replace_selection(combined(selection, area, how));
    }

    void replace_selection(Selection wanted) {
        end_stroke();
        history.remember(moment(), {Step::Kind::Select});
        selection = std::move(wanted);
    }

    Well& used_well() {
        if (!well) well = std::make_unique<Well>(medium, pool);
        share_varied();
        return *well;
    }

    /// What differs on one surface, the brush may carry to the other.
    void share_varied() {
        if (well) film.varied = well->film.varied = film.varied || well->film.varied;
    }

    void end_stroke() {
        if (!stroke) return;
        stroke->end();
        wiped += stroke->copied_paint();
        hand_over();
        stroke.reset();
    }

    /// Tells the solver and the account what the stroke did.
    void hand_over() {
        for (const grid::Rect& cells : stroke->take_changed_cells())
            touched->wake(cells);
        touched->set_air(stroke->air_jets());
        wiped += stroke->take_thrown_away();
    }

    void wipe_brush(double share = 1.0) {
        if (brush) wiped += brush->clean(share);
        ++brush_use;
    }

    brush::Contents held_paint() const {
        brush::Contents sum = brush ? brush->contents() : brush::Contents{};
        if (stroke) sum += stroke->copied_paint();
        return sum;
    }

    brush::Contents paint_in_well() const {
        return well ? document::contents_of(film::totals(well->film), well->film.cell_mm)
                    : brush::Contents{};
    }

    bool brush_holds_paint() const { return brush && brush->contents().volume_mm3 > 0.0; }

    /// The canvas has let a tick pass: the rest of the painting does too.
    void finish_tick(film::AdvanceReport flow) {
        if (well) {
            const int awake_tiles = flow.awake_tiles;
            flow.add(well->solver.advance(kTick_s));
            flow.awake_tiles += awake_tiles;
        }
        film_report.add(flow);
        age();
        ++tick;
    }

    void age() {
        ageing.tick(kTick_s, air, film, pool);
        if (!stroke) return;
        stroke->pass_time(kTick_s);
        hand_over();
    }

    film::Totals run_off() const { return difference(solver.runoff(), forgotten_run_off); }

    std::optional<film::FilmState> well_film() const {
        return well ? std::optional(well->film) : std::nullopt;
    }

    Step stroke_step(Surface surface) const {
        if (surface == Surface::Well) return {Step::Kind::StrokeInWell, brush->preset.name};
        return {Step::Kind::Stroke, brush->preset.name, active_name()};
    }
    /// Throws InputError when there is no such layer.
    Step layer_step(Step::Kind kind, LayerId layer) const {
        return {kind, {}, canvas.stack().layers[place_of(canvas.stack(), layer)].look.name};
    }
    Step group_step(Step::Kind kind, GroupId group) const {
        return {kind, {}, group_of(canvas.stack(), group).look.name};
    }
    const std::string& active_name() const {
        return canvas.stack().layers[canvas.stack().active].look.name;
    }

    Moment moment() const {
        Moment moment{.canvas = {film, solver.awake_tiles()},
                      .layers = canvas.stack(),
                      .brush = brush,
                      .medium = medium.name,
                      .selection = selection,
                      .tilt = tilt,
                      .brush_use = brush_use,
                      .taken = taken,
                      .wiped = wiped,
                      .run_off = run_off()};
        if (well) moment.well = {well->film, well->solver.awake_tiles()};
        return moment;
    }

    /// A brush that was not touched since then gets back what it held. Any other stays in hand as it is,
    /// as if it had been filled afresh, and what was on the old one counts as wiped off.
    void return_to(const Moment& then) {
        canvas.restore(then.canvas.film, then.layers);
        return_well_to(then);
        selection = then.selection;
        if (then.medium != medium.name) film.varied = true;
        taken = then.taken;
        wiped = then.wiped;
        forgotten_run_off = difference(solver.runoff(), then.run_off);
        if (brush_use == then.brush_use) {
            brush = then.brush;
        } else {
            if (brush) taken += brush->contents();
            if (then.brush) wiped += then.brush->contents();
        }
        restart(solver, then.canvas.awake, then.medium == medium.name && then.tilt == tilt);
    }

    void return_well_to(const Moment& then) {
        if (!then.well) {
            well.reset();
            return;
        }
        used_well().film = then.well->film;
        restart(well->solver, then.well->awake, then.medium == medium.name);
    }

    /// What rested then rests now, unless other forces act on it.
    static void restart(film::Solver& solver, const std::vector<bool>& awake, bool same_forces) {
        solver.restart(awake);
        if (!same_forces) solver.wake_all();
    }

    CanvasSettings settings;
    core::ThreadPool& pool;
    film::Medium medium;  ///< in hand: what the next load is mixed with
    LayeredCanvas canvas;
    film::FilmState& film = canvas.film;  ///< of the active layer
    film::Solver& solver = canvas.solver;
    std::unique_ptr<Well> well;  ///< none until something touches it
    TiltCanvas tilt;
    film::DryingAir air;
    film::AgeingClock ageing;
    std::optional<brush::Brush> brush;
    TakeBrush taken_brush;  ///< which one is in hand
    brush::HandAids aids;
    brush::Symmetry symmetry;
    Selection selection;
    std::optional<brush::StrokeGroup> stroke;
    film::Solver* touched = &solver;  ///< of the surface that the stroke is on
    brush::PenSample last_sample;
    std::uint64_t brush_use = 0;  ///< grows whenever the brush is taken, loaded or cleaned

    brush::Contents taken, wiped;
    film::Totals forgotten_run_off;  ///< ran off in a past that was undone
    History history;

    std::int64_t tick = 0;
    StageTimes times;
    film::AdvanceReport film_report;
};

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

std::int64_t Painting::tick() const {
    return parts_->tick;
}
const CanvasSettings& Painting::settings() const {
    return parts_->settings;
}
const film::FilmState& Painting::film() const {
    return parts_->film;
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
            parts_->selection};
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

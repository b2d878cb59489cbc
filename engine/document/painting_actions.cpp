// Brush, pen, well, media and the passing of time.
#include "core/error.hpp"
#include "document/action_checks.hpp"
#include "document/paint_mixing.hpp"
#include "document/painting_parts.hpp"
#include "film/cell/drying.hpp"

#include <utility>

namespace pastoso::document {
namespace {

const char* no_brush_for(Surface surface) {
    return surface == Surface::Canvas ? "the pen touches the canvas with no brush in hand."
                                      : "the pen touches the mixing well with no brush in hand.";
}

}  // namespace

void Painting::Parts::operator()(const TakeBrush& take) {
    brush::Brush fresh(preset_of(take), take.size_mm, take.seed);
    end_stroke();
    wipe_brush();
    brush = std::move(fresh);
    taken_brush = take;
}

void Painting::Parts::operator()(const LoadPaint& load) {
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

void Painting::Parts::operator()(const CleanBrush& clean) {
    end_stroke();
    wipe_brush(clean.share);
}

void Painting::Parts::operator()(const UseMedium& use) {
    const film::Medium next = medium_of(use);
    if (next != medium) {
        film.varied = film::has_wet_paint(film) || brush_holds_paint() || well;
        if (well) well->film.varied = true;
    }
    medium = next;
    used_medium = {next.name, use.own};
    solver.set_medium(medium);
    if (well) well->solver.set_medium(medium);
}

void Painting::Parts::operator()(const TiltCanvas& wanted) {
    tilt = wanted;
    solver.set_gravity(film::tilted_gravity(tilt.tilt_deg, tilt.direction_deg));
}

void Painting::Parts::operator()(const SetDrying& drying) {
    air = drying.air;
}

void Painting::Parts::operator()(const DryNow&) {
    check_unlocked(canvas.stack(), canvas.stack().active);
    end_stroke();
    history.remember(moment(), {Step::Kind::DryNow, {}, active_name()});
    film::dry_now(film, pool, selection.get());
}

void Painting::Parts::operator()(const PenDown& pen) {
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

void Painting::Parts::operator()(const PenMove& pen) {
    if (!stroke) return;
    check_time_order(last_sample, pen.sample);
    last_sample = pen.sample;
    stroke->add(pen.sample);
    hand_over();
}

void Painting::Parts::operator()(const PenUp&) {
    end_stroke();
}

void Painting::Parts::operator()(const SqueezePaint& squeeze) {
    end_stroke();
    history.remember(moment(), {Step::Kind::SqueezePaint});
    const film::PaintCoefficients paint = mixed_paint(squeeze.paint, medium);
    taken += squeeze_onto(used_well(), paint, squeeze.volume_mm3, squeeze.x_mm, squeeze.y_mm);
}

void Painting::Parts::operator()(const CleanWell&) {
    end_stroke();
    if (!well) return;
    history.remember(moment(), {Step::Kind::CleanWell});
    wiped += paint_in_well();
    well.reset();
}

void Painting::Parts::operator()(const SetStabiliser& set) {
    aids.stabiliser = set.stabiliser;
}

void Painting::Parts::operator()(const SetGuide& set) {
    aids.guide = set.guide;
}

void Painting::Parts::operator()(const SetSymmetry& set) {
    symmetry = set.symmetry;
}

void Painting::Parts::begin_stroke_on(Surface surface) {
    if (surface == Surface::Canvas) {
        share_varied();
        touched = &solver;
        stroke.emplace(*brush, film, aids, symmetry, selection.get(), &pool);
    } else {
        touched = &used_well().solver;
        stroke.emplace(*brush, well->film, brush::HandAids{aids.stabiliser, {}}, brush::Symmetry{},
                       nullptr, &pool);
    }
}

Well& Painting::Parts::used_well() {
    if (!well) well = std::make_unique<Well>(medium, pool);
    share_varied();
    return *well;
}

void Painting::Parts::share_varied() {
    if (well) film.varied = well->film.varied = film.varied || well->film.varied;
}

void Painting::Parts::end_stroke() {
    if (!stroke) return;
    stroke->end();
    wiped += stroke->copied_paint();
    hand_over();
    stroke.reset();
}

void Painting::Parts::hand_over() {
    for (const grid::Rect& cells : stroke->take_changed_cells())
        touched->wake(cells);
    touched->set_air(stroke->air_jets());
    wiped += stroke->take_thrown_away();
}

void Painting::Parts::wipe_brush(double share) {
    if (brush) wiped += brush->clean(share);
    ++brush_use;
}

brush::Contents Painting::Parts::held_paint() const {
    brush::Contents sum = brush ? brush->contents() : brush::Contents{};
    if (stroke) sum += stroke->copied_paint();
    return sum;
}

brush::Contents Painting::Parts::paint_in_well() const {
    return well ? document::contents_of(film::totals(well->film), well->film.cell_mm)
                : brush::Contents{};
}

void Painting::Parts::finish_tick(film::AdvanceReport flow) {
    if (well) {
        const int awake_tiles = flow.awake_tiles;
        flow.add(well->solver.advance(kTick_s));
        flow.awake_tiles += awake_tiles;
    }
    film_report.add(flow);
    age();
    ++tick;
}

void Painting::Parts::age() {
    ageing.tick(kTick_s, air, film, pool);
    if (!stroke) return;
    stroke->pass_time(kTick_s);
    hand_over();
}

}  // namespace pastoso::document

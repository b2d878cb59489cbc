#include "document/actions/fill_actions.hpp"

#include "document/actions/field_checks.hpp"
#include "document/living_painting.hpp"
#include "document/paint_mixing.hpp"
#include "film/cell/drying.hpp"
#include "layers/poured_film.hpp"

#include <cmath>
#include <utility>

namespace pastoso::document {
namespace {

grid::Point in_cells(const CanvasPoint& point, double cell_mm) {
    return {point.x_mm / cell_mm, point.y_mm / cell_mm};
}

layers::PouredPaint poured_paint(const FillWithPaint& fill, const film::Medium& medium, double cell_mm) {
    layers::PouredPaint paint{
        .medium = medium, .paint = mixed_paint(fill.paint, medium), .thickness_mm = fill.thickness_mm};
    if (!fill.line.empty())
        paint.gradient = {mixed_paint(fill.second, medium), in_cells(fill.line[0], cell_mm),
                          in_cells(fill.line[1], cell_mm)};
    return paint;
}

}  // namespace

void check_whole(const FillWithPaint& fill) {
    check_paint(fill.paint);
    check_paint(fill.second);
    if (fill.line.empty()) return;
    check_between(core::Pattern<0>("number of points of the gradient's line"), "",
                  static_cast<double>(fill.line.size()), 2.0, 2.0);
    for (const CanvasPoint& point : fill.line)
        check_point(core::message("gradient's point"), point);
    check_between(
        core::Pattern<0>("length of the gradient's line"), "mm",
        std::hypot(fill.line[1].x_mm - fill.line[0].x_mm, fill.line[1].y_mm - fill.line[0].y_mm),
        kLeastGradient_mm, 4.0 * kMaxPenPosition_mm);
}

void check_possible(const FillWithPaint&, const LivingPainting& painting) {
    check_paintable(painting.value.layers, painting.value.layers.active);
}

UndoStep undo_step(const FillWithPaint&, const LivingPainting& painting) {
    return {.name = Table<FillWithPaint>::kTraits.step, .layer = painting.active_layer().look.name};
}

void apply(const FillWithPaint& fill, LivingPainting& painting) {
    const film::FilmState& film = painting.value.film;
    const Selection reached = painting.within_reach();
    const film::FilmState poured =
        layers::poured_film(poured_paint(fill, painting.medium, film.cell_mm), film.shape, film.cell_mm,
                            reached.get(), painting.pool);
    painting.value.flows.taken += painting.contents_of(painting.canvas.pour(poured));
}

void check_whole(const ToneGround& tone) {
    check_paint(tone.paint);
}

void apply(const ToneGround& tone, LivingPainting& painting) {
    const film::FilmState& film = painting.value.film;
    const layers::PouredPaint coat{.medium = painting.medium,
                                   .paint = mixed_paint(tone.paint, painting.medium),
                                   .thickness_mm = tone.thickness_mm};
    const Selection open = without_masked(nullptr, painting.value.masking);
    film::FilmState ground =
        layers::poured_film(coat, film.shape, film.cell_mm, open.get(), painting.pool);
    film::dry_now(ground, painting.pool);
    painting.value.flows.taken +=
        painting.contents_of(painting.canvas.lay_ground(tone.name, std::move(ground)));
}

}  // namespace pastoso::document

#include "document/actions/canvas_actions.hpp"

#include "document/living_painting.hpp"
#include "layers/turning.hpp"

#include <cmath>
#include <memory>
#include <utility>

namespace pastoso::document {
namespace {

SharedTracing moved(const layers::Tracing& tracing, double x_mm, double y_mm) {
    auto elsewhere = std::make_shared<layers::Tracing>(tracing);
    elsewhere->place.x_mm += x_mm;
    elsewhere->place.y_mm += y_mm;
    return elsewhere;
}

/// Where the picture lies on a canvas that has been drawn out.
SharedTracing scaled(const layers::Tracing& tracing, const ScaleCanvas& scale) {
    auto elsewhere = std::make_shared<layers::Tracing>(tracing);
    layers::PicturePlace& place = elsewhere->place;
    place = {scale.scale_x * place.x_mm, scale.scale_y * place.y_mm, scale.scale_x * place.width_mm,
             scale.scale_y * place.height_mm};
    return elsewhere;
}

void resample(const layers::Resampling& resampling, std::shared_ptr<const BareCanvas> bare,
              LivingPainting& painting) {
    const brush::Contents lay = painting.contents_of(painting.canvas.paint());
    painting.canvas.resample(resampling, std::move(bare));
    painting.book(lay, painting.contents_of(painting.canvas.paint()));
    painting.value.selection = resampled(painting.value.selection, resampling);
    painting.mask(changed(painting.value.masking,
                          [&](const Selection& cells) { return resampled(cells, resampling); }));
}

}  // namespace

void put_in_hand(const TiltCanvas& tilt, PaintingValue& painting) {
    painting.tilt = tilt;
}

TiltCanvas in_hand(std::type_identity<TiltCanvas>, const PaintingValue& painting) {
    return painting.tilt;
}

void apply(const TiltCanvas& tilt, LivingPainting& painting) {
    put_in_hand(tilt, painting.value);
    painting.canvas.solver.set_gravity(film::tilted_gravity(tilt.tilt_deg, tilt.direction_deg));
}

void apply(const ResizeCanvas& resize, LivingPainting& painting) {
    PaintingValue& value = painting.value;
    const grid::Extent extent = extent_of(resize, value.bare->settings);
    auto ready = std::exchange(painting.ready_canvas, std::nullopt);
    if (!ready || ready->resize != resize || ready->before != value.bare)
        ready = resized_canvas(resize, value.bare, painting.pool);
    painting.book(painting.canvas.resize(extent, std::move(ready->after)));
    value.selection = on_extent(value.selection, extent);
    painting.mask(
        changed(value.masking, [&](const Selection& cells) { return on_extent(cells, extent); }));
    const double cell_mm = value.film.cell_mm;
    if (value.tracing) value.tracing = moved(*value.tracing, -extent.x0 * cell_mm, -extent.y0 * cell_mm);
}

bool changes_anything(const TurnCanvas& turn, const LivingPainting&) {
    return turn.turn != core::Orientation{};
}

UndoStep undo_step(const TurnCanvas& turn, const LivingPainting&) {
    using Told = Table<TurnCanvas>;
    return {.name = turn.turn.mirrored ? Told::kMirrored : Told::kTraits.step.value};
}

void apply(const TurnCanvas& turn, LivingPainting& painting) {
    PaintingValue& value = painting.value;
    auto bare = std::make_shared<const BareCanvas>(turned(turn.turn, *value.bare, painting.pool));
    if (value.tracing)
        value.tracing = std::make_shared<const layers::Tracing>(
            layers::turned(*value.tracing, turn.turn, value.film.shape.width * value.film.cell_mm,
                           value.film.shape.height * value.film.cell_mm));
    value.selection = turned(value.selection, turn.turn, painting.pool);
    painting.canvas.turn(turn.turn, std::move(bare));
    painting.mask(changed(
        value.masking, [&](const Selection& cells) { return turned(cells, turn.turn, painting.pool); }));
}

bool changes_anything(const ScaleCanvas& scale, const LivingPainting&) {
    return scale != ScaleCanvas{};
}

void apply(const ScaleCanvas& scale, LivingPainting& painting) {
    PaintingValue& value = painting.value;
    const layers::Resampling resampling = resampling_of(scale, value.bare->settings);
    auto bare = std::make_shared<const BareCanvas>(scaled(scale, *value.bare, painting.pool));
    painting.forget_run_off();
    resample(resampling, std::move(bare), painting);
    if (value.tracing) value.tracing = scaled(*value.tracing, scale);
}

bool changes_anything(const RotateCanvas& rotate, const LivingPainting&) {
    return std::remainder(rotate.turn_deg, 360.0) != 0.0;
}

void apply(const RotateCanvas& rotate, LivingPainting& painting) {
    PaintingValue& value = painting.value;
    const CanvasSettings before = value.bare->settings;
    auto bare = std::make_shared<const BareCanvas>(rotated(rotate, *value.bare, painting.pool));
    resample(resampling_of(rotate, before), std::move(bare), painting);
    if (value.tracing)
        value.tracing = std::make_shared<const layers::Tracing>(
            layers::rotated(*value.tracing, rotation_of(rotate, before)));
}

}  // namespace pastoso::document

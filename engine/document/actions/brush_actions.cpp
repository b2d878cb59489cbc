#include "document/actions/brush_actions.hpp"

#include "core/error.hpp"
#include "document/living_painting.hpp"
#include "document/paint_mixing.hpp"

#include <utility>

namespace pastoso::document {
namespace {

BrushInHand clean_brush(const TakeBrush& take, const BrushInHand* before) {
    brush::Brush brush(preset_of(take), take.size_mm, take.seed);
    if (before) brush.gathering.number = before->brush.gathering.number;
    brush.shape_tip();
    return {take, std::move(brush)};
}

TakeBrush told_in_full(TakeBrush take) {
    take.definition = brush::preset_to_json(preset_of(take));
    return take;
}

}  // namespace

brush::Preset preset_of(const TakeBrush& take) {
    if (take.definition.empty()) return brush::find_preset(take.preset);
    return brush::parse_preset(take.definition, core::message("the brush \"%1\"", take.preset));
}

void check_whole(const TakeBrush& take) {
    preset_of(take);
}

void check_whole(const LayBrushAside& lay) {
    preset_of(lay.brush);
}

void check_whole(const LoadPaint& load) {
    check_paint(load.paint);
    check_paint(load.second);
}

void check_possible(const LoadPaint&, const LivingPainting& painting) {
    if (!painting.value.brush) throw core::InputError("there is no brush in hand to take paint with.");
}

void put_in_hand(const TakeBrush& take, PaintingValue& painting) {
    painting.brush = clean_brush(take, painting.brush ? &*painting.brush : nullptr);
}

std::optional<TakeBrush> in_hand(std::type_identity<TakeBrush>, const PaintingValue& painting) {
    if (!painting.brush) return std::nullopt;
    return told_in_full(painting.brush->taken);
}

void put_in_hand(const LayBrushAside& lay, PaintingValue& painting) {
    painting.brush_aside =
        std::make_shared<const BrushInHand>(clean_brush(lay.brush, painting.brush_aside.get()));
}

std::optional<LayBrushAside> in_hand(std::type_identity<LayBrushAside>, const PaintingValue& painting) {
    if (!painting.brush_aside) return std::nullopt;
    return LayBrushAside{told_in_full(painting.brush_aside->taken)};
}

void apply(const TakeBrush& take, LivingPainting& painting) {
    PaintingValue& value = painting.value;
    if (value.brush) value.flows.wiped += value.brush->brush.clean();
    put_in_hand(take, value);
    painting.touch_brush();
}

void apply(const LayBrushAside& lay, LivingPainting& painting) {
    PaintingValue& value = painting.value;
    if (value.brush_aside) value.flows.wiped += value.brush_aside->brush.contents();
    put_in_hand(lay, value);
}

void apply(const SwapBrushes&, LivingPainting& painting) {
    PaintingValue& value = painting.value;
    if (value.brush_aside == nullptr) return;
    const BrushAside taken = std::move(value.brush_aside);
    value.brush_aside =
        value.brush ? std::make_shared<const BrushInHand>(*std::move(value.brush)) : nullptr;
    value.brush = *taken;
    painting.touch_brush();
}

void apply(const LoadPaint& load, LivingPainting& painting) {
    brush::MixedLoad paint{.first = mixed_paint(load.paint, painting.medium),
                           .tip_only = load.tip_only,
                           .medium = film::film_numbers_of(painting.medium)};
    if (!load.second.ingredients.empty()) {
        paint.second = mixed_paint(load.second, painting.medium);
        paint.second_share = load.second_share;
        paint.share_variation = load.share_variation;
        paint.side_by_side = load.side_by_side;
    }
    painting.value.flows.taken += painting.value.brush->brush.load(paint, load.fill);
    painting.touch_brush();
}

void apply(const CleanBrush& clean, LivingPainting& painting) {
    if (!painting.value.brush) return;
    painting.value.flows.wiped += painting.value.brush->brush.clean(clean.share);
    painting.touch_brush();
}

}  // namespace pastoso::document

#include "document/actions/layer_actions.hpp"

#include "document/actions/field_checks.hpp"
#include "document/living_painting.hpp"

#include <cmath>

namespace pastoso::document {
namespace {

void check_scale(const char* axis, double scale) {
    check_between(core::message("scale of the transform along %1, without its sign,", axis), "",
                  std::abs(scale), kLeastScale, kMostScale);
}

}  // namespace

void check_whole(const TransformLayer& move) {
    check_scale("x", move.transform.scale_x);
    check_scale("y", move.transform.scale_y);
}

void apply(const AddLayer& add, LivingPainting& painting) {
    painting.canvas.add(add);
}

void apply(const SelectLayer& select, LivingPainting& painting) {
    painting.canvas.select(select);
}

void apply(const SetLayer& set, LivingPainting& painting) {
    painting.canvas.set(set);
}

void apply(const DuplicateLayer& duplicate, LivingPainting& painting) {
    painting.value.flows.taken += painting.contents_of(painting.canvas.duplicate(duplicate));
}

void apply(const RemoveLayer& remove, LivingPainting& painting) {
    painting.value.flows.wiped += painting.contents_of(painting.canvas.remove(remove));
}

void apply(const ClearLayer& clear, LivingPainting& painting) {
    const LayerPaint wiped = painting.canvas.clear(clear, painting.unmasked().get());
    painting.value.flows.wiped += painting.contents_of(wiped);
}

void apply(const TransformLayer& transform, LivingPainting& painting) {
    PaintingValue& value = painting.value;
    painting.book(painting.canvas.transform(transform, value.selection.get()));
    value.selection = transformed(value.selection, value.film.cell_mm, transform.transform);
}

void apply(const MoveLayer& move, LivingPainting& painting) {
    painting.canvas.move(move);
}

void apply(const MergeDown& merge, LivingPainting& painting) {
    painting.canvas.merge_down(merge);
}

void apply(const FlattenLayers&, LivingPainting& painting) {
    painting.canvas.flatten();
}

}  // namespace pastoso::document

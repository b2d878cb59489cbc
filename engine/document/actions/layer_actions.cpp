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

void move_paint(LayerId layer, const layers::Projective& map_cells, LivingPainting& painting) {
    PaintingValue& value = painting.value;
    painting.book(painting.canvas.transform(layer, map_cells, painting.unmasked().get()));
    value.selection = transformed(value.selection, map_cells);
}

}  // namespace

void check_whole(const TransformLayer& move) {
    check_scale("x", move.transform.scale_x);
    check_scale("y", move.transform.scale_y);
}

void check_whole(const DistortLayer& distort) {
    const layers::Distortion& told = distort.distortion;
    const layers::Corners corners = layers::corners_in_cells(told, 1.0);
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const grid::Point &from = corners[k], &to = corners[(k + 1) % corners.size()];
        const double before_mm = k % 2 == 0 ? told.width_mm : told.height_mm;
        check_between(core::message("length of a side of the distortion, times what it was,"), "",
                      std::hypot(to.x - from.x, to.y - from.y) / before_mm, kLeastScale, kMostScale);
    }
    if (layers::bends_outwards(corners)) return;
    throw core::InputError(
        "the corners of the distortion have to go round an area that bends outwards at each of them, "
        "by %1 degree or more.",
        layers::kLeastBend_deg);
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
    move_paint(transform.layer, layers::in_cells(transform.transform, painting.value.film.cell_mm),
               painting);
}

void apply(const DistortLayer& distort, LivingPainting& painting) {
    move_paint(distort.layer, layers::in_cells(distort.distortion, painting.value.film.cell_mm),
               painting);
}

void apply(const MoveLayer& move, LivingPainting& painting) {
    painting.canvas.move(move);
}

void apply(const MergeDown& merge, LivingPainting& painting) {
    painting.value.flows.wiped += painting.contents_of(painting.canvas.merge_down(merge));
}

void apply(const FlattenLayers&, LivingPainting& painting) {
    painting.value.flows.wiped += painting.contents_of(painting.canvas.flatten());
}

}  // namespace pastoso::document

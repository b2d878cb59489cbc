// Layers, selections and the size of the canvas.
#include "core/memory.hpp"
#include "document/canvas.hpp"
#include "document/painting_parts.hpp"
#include "film/support/support.hpp"
#include "layers/extent.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::document {
namespace {

brush::Contents positive_part(const brush::Contents& contents, double sign) {
    brush::Contents part;
    part.volume_mm3 = std::max(0.0, sign * contents.volume_mm3);
    for (int k = 0; k < film::kPaintChannels; ++k)
        part.paint[k] = std::max(0.0, sign * contents.paint[k]);
    return part;
}

layers::Tracing moved(layers::Tracing tracing, double x_mm, double y_mm) {
    tracing.place.x_mm += x_mm;
    tracing.place.y_mm += y_mm;
    return tracing;
}

}  // namespace

void Painting::Parts::operator()(const SelectArea& area) {
    select(area_of(area, film), area.how);
}

void Painting::Parts::operator()(const SelectByHeight& heights) {
    end_stroke();
    select(area_of(heights, film, canvas.bare_mm()), heights.how);
}

void Painting::Parts::operator()(const SelectByWetness& wetness) {
    end_stroke();
    select(area_of(wetness, film), wetness.how);
}

void Painting::Parts::operator()(const InvertSelection&) {
    if (selection) replace_selection(inverted(selection));
}

void Painting::Parts::operator()(const SelectAll&) {
    if (selection) replace_selection(nullptr);
}

void Painting::Parts::operator()(const SelectLayer& select) {
    end_stroke();
    canvas.select(select);
}

void Painting::Parts::operator()(const AddLayer& add) {
    change_layers({Step::Kind::AddLayer, {}, add.name}, [&] { canvas.add(add); });
}

void Painting::Parts::operator()(const PaintPicture& paint) {
    change_layers({Step::Kind::PaintPicture, {}, paint.name},
                  [&] { taken += contents_of(canvas.paint_picture(paint)); });
}

void Painting::Parts::operator()(const LayTracing& lay) {
    if (!lay.picture && !tracing) return;
    end_stroke();
    history.remember(moment(), {Step::Kind::LayTracing});
    if (!lay.picture) return tracing.reset();
    const double opacity = tracing ? tracing->opacity : layers::Tracing{}.opacity;
    replace_tracing({lay.picture, lay.place, opacity});
}

void Painting::Parts::operator()(const SetTracing& set) {
    if (!tracing) return;
    end_stroke();
    history.remember(moment(), {Step::Kind::SetTracing});
    replace_tracing({tracing->picture, set.place, set.opacity});
}

void Painting::Parts::replace_tracing(layers::Tracing wanted) {
    tracing = std::make_shared<const layers::Tracing>(std::move(wanted));
}

void Painting::Parts::operator()(const SetLayer& set) {
    change_layers(layer_step(Step::Kind::SetLayer, set.layer), [&] { canvas.set(set); });
}

void Painting::Parts::operator()(const SetGroup& set) {
    change_layers(group_step(Step::Kind::SetGroup, set.group), [&] { canvas.set_group(set); });
}

void Painting::Parts::operator()(const MoveLayer& move) {
    change_layers(layer_step(Step::Kind::MoveLayer, move.layer), [&] { canvas.move(move); });
}

void Painting::Parts::operator()(const MoveGroup& move) {
    change_layers(group_step(Step::Kind::MoveGroup, move.group), [&] { canvas.move_group(move); });
}

void Painting::Parts::operator()(const GroupLayers& group) {
    change_layers({Step::Kind::GroupLayers, {}, group.name}, [&] { canvas.group(group); });
}

void Painting::Parts::operator()(const UngroupLayers& ungroup) {
    change_layers(group_step(Step::Kind::UngroupLayers, ungroup.group),
                  [&] { canvas.ungroup(ungroup); });
}

void Painting::Parts::operator()(const MergeDown& merge) {
    change_layers(layer_step(Step::Kind::MergeDown, merge.layer), [&] { canvas.merge_down(merge); });
}

void Painting::Parts::operator()(const FlattenLayers&) {
    change_layers({Step::Kind::FlattenLayers}, [&] { canvas.flatten(); });
}

void Painting::Parts::operator()(const DuplicateLayer& duplicate) {
    change_layers(layer_step(Step::Kind::DuplicateLayer, duplicate.layer),
                  [&] { taken += contents_of(canvas.duplicate(duplicate)); });
}

void Painting::Parts::operator()(const RemoveLayer& remove) {
    change_layers(layer_step(Step::Kind::RemoveLayer, remove.layer),
                  [&] { wiped += contents_of(canvas.remove(remove)); });
}

void Painting::Parts::operator()(const ClearLayer& clear) {
    change_layers(layer_step(Step::Kind::ClearLayer, clear.layer),
                  [&] { wiped += contents_of(canvas.clear(clear, selection.get())); });
}

void Painting::Parts::operator()(const TransformLayer& transform) {
    change_layers(layer_step(Step::Kind::TransformLayer, transform.layer), [&] {
        book(canvas.transform(transform, selection.get()));
        selection = transformed(selection, film.cell_mm, transform.transform);
    });
}

void Painting::Parts::operator()(const ResizeCanvas& resize) {
    end_stroke();
    CanvasSettings wanted = resized(resize, bare->settings);
    check_canvas_fits(wanted, core::available_memory_bytes());
    const grid::Extent extent = extent_of(resize, bare->settings);
    film::SupportHeights support_mm = resized_support(wanted, extent);
    history.remember(moment(), {Step::Kind::ResizeCanvas});
    book(canvas.resize(extent, support_mm));
    selection = on_extent(selection, extent);
    if (tracing) replace_tracing(moved(*tracing, -extent.x0 * film.cell_mm, -extent.y0 * film.cell_mm));
    bare = std::make_shared<const BareCanvas>(BareCanvas{std::move(wanted), std::move(support_mm)});
}

film::SupportHeights Painting::Parts::resized_support(const CanvasSettings& wanted,
                                                      const grid::Extent& extent) {
    if (wanted.support == "image") return layers::widened(bare->support_mm, extent);
    return named_support(wanted, pool, film::form_of(bare->support_mm));
}

void Painting::Parts::book(const LayerChange& paint) {
    brush::Contents gained = contents_of(paint.after);
    gained -= contents_of(paint.before);
    taken += positive_part(gained, 1.0);
    wiped += positive_part(gained, -1.0);
}

brush::Contents Painting::Parts::contents_of(const LayerPaint& paint) const {
    brush::Contents sum = document::contents_of(paint.wet, film.cell_mm);
    sum += document::contents_of(paint.dried, film.cell_mm);
    sum.volume_mm3 += film::volume_mm3(paint.evaporated, film.cell_mm);
    return sum;
}

void Painting::Parts::select(const grid::Mask& area, Combination how) {
    replace_selection(combined(selection, area, how));
}

void Painting::Parts::replace_selection(Selection wanted) {
    end_stroke();
    history.remember(moment(), {Step::Kind::Select});
    selection = std::move(wanted);
}

const std::shared_ptr<const LayerStack>& Painting::Parts::shared_layers() {
    if (!layers_shown || *layers_shown != canvas.stack())
        layers_shown = std::make_shared<const LayerStack>(canvas.stack());
    return layers_shown;
}

}  // namespace pastoso::document

#include "document/actions/canvas_actions.hpp"

#include "core/memory.hpp"
#include "document/living_painting.hpp"
#include "film/support/support.hpp"
#include "layers/extent.hpp"

#include <memory>
#include <utility>

namespace pastoso::document {
namespace {

film::SupportHeights resized_support(const BareCanvas& bare, const CanvasSettings& wanted,
                                     const grid::Extent& extent, core::ThreadPool& pool) {
    if (wanted.support == "image") return layers::widened(bare.support_mm, extent);
    return named_support(wanted, pool, film::form_of(bare.support_mm));
}

SharedTracing moved(const layers::Tracing& tracing, double x_mm, double y_mm) {
    auto elsewhere = std::make_shared<layers::Tracing>(tracing);
    elsewhere->place.x_mm += x_mm;
    elsewhere->place.y_mm += y_mm;
    return elsewhere;
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
    const BareCanvas& bare = *value.bare;
    BareCanvas wanted{.settings = resized(resize, bare.settings), .support_mm = {}};
    check_canvas_fits(wanted.settings, core::available_memory_bytes());
    const grid::Extent extent = extent_of(resize, bare.settings);
    wanted.support_mm = resized_support(bare, wanted.settings, extent, painting.pool);
    painting.book(painting.canvas.resize(extent, std::make_shared<const BareCanvas>(std::move(wanted))));
    value.selection = on_extent(value.selection, extent);
    const double cell_mm = value.film.cell_mm;
    if (value.tracing) value.tracing = moved(*value.tracing, -extent.x0 * cell_mm, -extent.y0 * cell_mm);
}

}  // namespace pastoso::document

#include "document/actions/texture_actions.hpp"

#include "core/check.hpp"
#include "document/actions/field_checks.hpp"
#include "document/living_painting.hpp"
#include "document/paint_mixing.hpp"
#include "film/cell/drying.hpp"
#include "layers/poured_film.hpp"
#include "layers/texture/texture_relief.hpp"

#include <variant>

namespace pastoso::document {
namespace {

/// What gives paste its body stays when it dries.
film::Medium unshrinking(film::Medium medium) {
    medium.solid_fraction = 1.0;
    return medium;
}

}  // namespace

void check_whole(const LayTexture& lay) {
    check_paint(lay.paint);
    if (const auto* pressed = std::get_if<layers::PressedTexture>(&lay.texture)) {
        PASTOSO_CHECK(pressed->picture != nullptr);
        check_picture(*pressed->picture);
    }
}

void check_possible(const LayTexture&, const LivingPainting& painting) {
    check_paintable(painting.value.layers, painting.value.layers.active);
}

UndoStep undo_step(const LayTexture&, const LivingPainting& painting) {
    return {.name = Table<LayTexture>::kTraits.step, .layer = painting.active_layer().look.name};
}

void apply(const LayTexture& lay, LivingPainting& painting) {
    const film::FilmState& film = painting.value.film;
    const film::Medium paste = unshrinking(painting.medium);
    const Selection reached = painting.within_reach();
    const auto relief =
        layers::texture_relief(lay.texture, film.shape, film.cell_mm, reached.get(), painting.pool);
    film::FilmState coat =
        layers::poured_film({.medium = paste, .paint = mixed_paint(lay.paint, paste), .relief = &relief},
                            film.shape, film.cell_mm, nullptr, painting.pool);
    film::dry_now(coat, painting.pool);
    painting.value.flows.taken += painting.contents_of(painting.canvas.pour(coat));
}

}  // namespace pastoso::document

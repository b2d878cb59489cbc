// All that a layer holds cell by cell, for what brings cells into other places.
#pragma once

#include "film/state.hpp"

namespace pastoso::layers {

/// Calls visit(field, the same field of the other) for what cells of a layer hold but for velocities,
/// which lie between cells, and for media, which tiles tell together (told_media()).
template <class Visit>
void for_each_cell_field(const Visit& visit, const film::FilmState& layer, film::FilmState& other) {
    const film::Strata& strata = layer.strata;
    visit(layer.thickness, other.thickness);
    visit(layer.paint, other.paint);
    visit(layer.lower.thickness, other.lower.thickness);
    visit(layer.lower.paint, other.lower.paint);
    visit(layer.worked.thickness, other.worked.thickness);
    visit(layer.support_mm, other.support_mm);
    visit(strata.soluble_thickness, other.strata.soluble_thickness);
    visit(strata.soluble_pigment, other.strata.soluble_pigment);
    visit(strata.optics, other.strata.optics);
    visit(strata.uppermost, other.strata.uppermost);
}

using MediaCells = grid::TiledField<film::MediaCell>;

/// How much of each medium every cell holds, which tiles tell together.
MediaCells told_media(const film::FilmState& layer);

/// Says it of a layer with the same media.
void put_media(const MediaCells& told, film::FilmState& layer);

}  // namespace pastoso::layers

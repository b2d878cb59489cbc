// A layer apart from what it lies on: a film whose support is nothing but its own dried relief, so that
// it can lie on anything. All heights are multiples of kSupportQuantum_mm: up to 16 mm they add up
// exactly. Sums and differences are floats, whatever they are made of (film/support_heights.hpp).
#pragma once

#include "film/state.hpp"

namespace pastoso::layers {

using Heights = film::SupportHeights;

/// The layer of a film that lies on `base_mm`; its paint, its velocities and its strata are shared with
/// it. Tiles of the support that are the base's own have no relief.
film::FilmState lifted_off(const film::FilmState& film, const Heights& base_mm);

/// The film that a layer makes on `base_mm`: lifted_off() the other way round.
film::FilmState laid_on(const film::FilmState& layer, const Heights& base_mm);

/// Lifts a film off its base again and again, and computes only what has changed since.
class Lifter {
  public:
    film::FilmState lifted_off(const film::FilmState& film, const Heights& base_mm);

  private:
    Heights support_mm_, base_mm_, relief_mm_;  ///< of the last call
};

/// Adds all that a layer holds, dry and wet, to the heights. Wet paint counts as the nearest multiple of
/// kSupportQuantum_mm.
void raise_by(const film::FilmState& layer, Heights& heights_mm);

/// The height of wet paint as a support.
float wet_height_mm(std::int32_t thickness_quanta);

/// Whether the layer holds anything in the tile, wet or dry.
bool holds_paint(const film::FilmState& layer, int tile);

/// The same of a cell.
bool holds_paint(const film::FilmState& layer, int x, int y);

/// The same of dry paint alone.
bool holds_dry_paint(const film::FilmState& layer, int tile);
bool holds_dry_paint(const film::FilmState& layer, int x, int y);

/// The smallest rectangle around the cells that hold anything.
grid::Rect painted_area(const film::FilmState& layer);

/// Makes a tile of one field that of another, of the same shape.
template <class Field>
void share_tile(const Field& from, int tile, Field& to) {
    if (from.is_background(tile))
        to.reset(tile);
    else
        to.replace(tile, from.block(tile));
}

/// Whether a tile of two fields of one shape is the same one, or nothing in both.
template <class Field>
bool same_tile(const Field& a, const Field& b, int tile) {
    return a.shares_tile(b, tile) || (a.is_background(tile) && b.is_background(tile));
}

/// The same for all that is seen of a layer in a tile.
bool looks_same(const film::FilmState& a, const film::FilmState& b, int tile);

/// share_tile() for all that is seen of a layer in a tile: everything but structure, media, velocities
/// and totals.
void take_seen_tile(const film::FilmState& from, int tile, film::FilmState& to);

/// The same for all that a layer holds in a tile. Its totals stay as they are.
void take_tile(const film::FilmState& from, int tile, film::FilmState& to);

}  // namespace pastoso::layers

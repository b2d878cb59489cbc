// A layer in two along the border of a mask, and what share of its fixed paint goes where.
#pragma once

#include "film/state.hpp"
#include "grid/mask.hpp"

#include <cstdint>

namespace pastoso::layers {

/// Both apart from what they lie on, like the layer they were.
struct CutLayer {
    film::FilmState inside, outside;
};

/// What lies on the cells of the mask, and the rest. Cell by cell one of the two has what the layer had
/// and the other nothing; along soft edges the inside has its share, by keep_share(). Fixed paint is
/// counted by share_fixed(); what has evaporated stays with the outside. Velocities stay where both
/// cells of their face do, others are 0.
CutLayer cut(const film::FilmState& layer, const grid::Mask& mask);

/// Empties the cells of a tile that the mask does not choose. Velocities and totals stay as they are.
void keep_chosen(const grid::Mask& mask, int tile, film::FilmState& layer);

/// Thickness quanta of the fixed strata, by the relief: sum over the cells of relief - soluble
/// thickness.
std::int64_t fixed_relief_quanta(const film::FilmState& layer);

/// Of fixed paint only the thickness is known cell by cell; its pigments are known in all, and count as
/// spread evenly over it. What `part` has of `whole`, whose fixed strata are known to be `fixed`:
/// fixed * fixed_relief_quanta(part) / fixed_relief_quanta(whole), rounded; all of it where neither has
/// relief.
film::DriedTotals share_fixed(const film::DriedTotals& fixed, std::int64_t part_quanta,
                              std::int64_t whole_quanta);

}  // namespace pastoso::layers

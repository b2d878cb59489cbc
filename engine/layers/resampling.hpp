// What lies on a canvas, made anew of cells that lie otherwise or are of another size.
#pragma once

#include "core/thread_pool.hpp"
#include "film/state.hpp"
#include "grid/mask.hpp"
#include "layers/apart.hpp"
#include "layers/footprint.hpp"

namespace pastoso::layers {

/// What a cell that comes from beyond the canvas is made of: nothing, or the outermost cell going on.
enum class Beyond { Bare, GoesOn };

struct Resampling {
    Projective map;     ///< from places before to places after, both in cells; can be inverted
    grid::Shape shape;  ///< of the canvas after it
    double cell_mm;     ///< of its cells
    Beyond beyond = Beyond::Bare;
};

/// What lies on a layer, apart from what it lies on. Every cell gets the mean of what its place was
/// before (footprint.hpp): thicknesses, optical thicknesses and all that wet paint carries, relief, and
/// what fixed paint does to light.
///
/// Paint keeps its thickness. Maps that bring cells onto cells are exact; otherwise every cell is
/// rounded, and what was fine is blurred by half a cell. What comes to lie beyond the canvas is gone.
/// Paint begins at rest. The volume that has evaporated is unchanged, rounded to whole quanta of a cell.
film::FilmState resampled(const film::FilmState& layer, const Resampling& resampling,
                          core::ThreadPool& pool);

/// The cells whose middles come from chosen ones.
grid::Mask resampled(const grid::Mask& mask, const Resampling& resampling);

/// Heights of a support, which go on beyond the canvas, as means and in whole kSupportQuantum_mm.
Heights resampled(const Heights& heights_mm, const Resampling& resampling, core::ThreadPool& pool);

}  // namespace pastoso::layers

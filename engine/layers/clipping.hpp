// Layers of which only what lies over the paint of another one shows.
#pragma once

#include "film/state.hpp"
#include "grid/mask.hpp"

namespace pastoso::layers {

/// Thinner paint than this is no more than what rounding leaves.
inline constexpr double kLeastPaint_mm = 1e-4;

/// The cells in which a layer, apart from what it lies on, has paint, wet and dry together, of
/// kLeastPaint_mm or more.
grid::Mask painted_cells(const film::FilmState& layer);

/// A layer in two, cell by cell: what shows of it, and what is hidden.
struct ClippedLayer {
    film::FilmState shown, hidden;
};

/// What lies on the painted_cells() of `onto` shows (layers/cutting.hpp). What has evaporated stays with
/// what shows. Both layers are apart from what they lie on.
ClippedLayer clipped(const film::FilmState& layer, const film::FilmState& onto);

/// Clips a layer again and again to be looked at, and looks anew only at tiles in which one of both has
/// changed.
class Clipper {
  public:
    /// clipped().shown, of which counts, structure, media and velocities are left out. Stays until the
    /// next call; tiles that look the same as in the last one are shared with it.
    const film::FilmState& shown(const film::FilmState& layer, const film::FilmState& onto);

  private:
    /// Whether other cells of the tile are painted than before.
    bool find_painted(int tile, const film::FilmState& onto);
    void show(int tile, const film::FilmState& layer);

    film::FilmState layer_, onto_;  ///< of the last call
    grid::Mask painted_;            ///< cells of onto_
    film::FilmState bare_, shown_;
};

}  // namespace pastoso::layers

// A picture that a painter traces: seen as if it lay between the support and the paint, and part of
// neither.
#pragma once

#include "core/thread_pool.hpp"
#include "film/state.hpp"
#include "layers/picture_place.hpp"
#include "pigment/image.hpp"

#include <array>
#include <cstdint>
#include <memory>

namespace pastoso::layers {

struct Tracing {
    std::shared_ptr<const pigment::Picture> picture;  ///< not null
    PicturePlace place;
    double opacity = 0.5;  ///< 0 to 1
    friend bool operator==(const Tracing& a, const Tracing& b) {
        return a.place == b.place && a.opacity == b.opacity &&
               (a.picture == b.picture || *a.picture == *b.picture);
    }
};

/// What a picture has in a cell: its colour as paint (pigment::rgb_bands()) and how much of the cell it
/// covers, in 65535ths; beside it all 0.
struct PictureCell {
    std::array<std::uint16_t, pigment::kBands> reflectance{};
    std::uint16_t coverage = 0;
};
using PictureCells = grid::TiledField<PictureCell>;

PictureCells picture_cells(const pigment::Picture& picture, const PicturePlace& place, grid::Shape shape,
                           double cell_mm, core::ThreadPool& pool);

/// What a picture does to light in each cell, clear beside it. Fields share tiles.
using PictureStrata = grid::TiledField<film::StrataOptics>;

/// The cells as opaque paint on so large a share of what they cover (picture_optics()): over whatever
/// ground, what is seen is that share of the picture and the rest of the ground.
PictureStrata picture_strata(const PictureCells& cells, double opacity, core::ThreadPool& pool);

/// A painting seen on a picture. Keeps what it saw, and looks anew only where dry paint has changed.
class TracedView {
  public:
    /// `seen` with its strata laid over the picture, a field of its shape. Its heights, its wet paint
    /// and its account are as they were.
    film::FilmState of(const film::FilmState& seen, const PictureStrata& picture,
                       core::ThreadPool& pool);

  private:
    PictureStrata above_, picture_, result_;  ///< of the last call
};

}  // namespace pastoso::layers

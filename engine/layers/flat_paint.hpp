// A picture as a layer of dry paint: thin, even and opaque.
#pragma once

#include "core/thread_pool.hpp"
#include "film/state.hpp"
#include "layers/picture_place.hpp"
#include "pigment/image.hpp"

namespace pastoso::layers {

/// The relief of paint that covers all of a cell, a multiple of film::kSupportQuantum_mm: about 0.02 mm.
inline constexpr double kFlatPaint_mm = 20480 * film::kSupportQuantum_mm;

/// What opaque paint of that reflectance on a share of the area does to light: whatever lies below, it
/// looks like the pixels of a picture (pigment::laid_in_part).
film::StrataOptics picture_optics(const pigment::Bands& reflectance, float coverage);

/// The picture on a bare layer apart from what it lies on. Every cell has the mean of what it covers of
/// the picture (picture_means.hpp): its colour as paint (pigment/rgb_bands.hpp), all dry and fixed, and
/// kFlatPaint_mm of relief times its coverage.
///
/// What it does to light is that of picture_optics(). What is counted of it is its thickness and the
/// pigment of as much paint of that colour (pigment::paint_of_bands).
film::FilmState flat_paint(const pigment::Picture& picture, const PicturePlace& place, grid::Shape shape,
                           double cell_mm, core::ThreadPool& pool);

}  // namespace pastoso::layers

// What other programs open: the pictures of an OpenRaster file (version 0.0.3 of its specification).
#pragma once

#include "core/thread_pool.hpp"
#include "film/state.hpp"
#include "pigment/bands.hpp"
#include "shade/render.hpp"

#include <string>

namespace pastoso::project {

/// The longest side of the picture: of a larger canvas, a half, a fourth ... of the resolution is shown.
inline constexpr int kLongestPicture_px = 2048;
/// The longest side of a thumbnail, which OpenRaster gives.
inline constexpr int kLongestThumbnail_px = 256;

/// The canvas in daylight.
shade::LinearImage open_raster_picture(const film::FilmState& film, const pigment::Bands& ground,
                                       core::ThreadPool& pool);

/// The picture made smaller: the mean over each pixel's area.
shade::LinearImage thumbnail_of(const shade::LinearImage& picture);

/// stack.xml with one layer.
std::string stack_xml(const shade::LinearImage& picture, double px_per_mm, const std::string& layer,
                      const std::string& source);

}  // namespace pastoso::project

// How a small picture of a canvas is made: as large as fits into a box, each pixel of a few cells.
#pragma once

#include "grid/shape.hpp"

namespace pastoso::session {

/// A pixel shows at most so many cells a side: a picture of a large canvas takes no longer than that of
/// a small one.
inline constexpr int kMostCells = 4;

struct PictureSize {
    int width = 1, height = 1;
    friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

PictureSize size_within(const grid::Shape& canvas, int most_width, int most_height);

/// The cells that a pixel of a picture of that size shows.
grid::Rect cells_of_pixel(int x, int y, const PictureSize& picture, const grid::Shape& canvas);

}  // namespace pastoso::session

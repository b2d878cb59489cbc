// How a canvas is cut into pages that a graphics card can hold, where it cannot hold it in one.
#pragma once

#include "grid/shape.hpp"

#include <vector>

namespace pastoso::screen {

/// The shader samples the four cells around a point, so the layers go on beyond the canvas by as many,
/// and pages beyond their own cells.
inline constexpr int kLayerBorder = 2;

/// Pages lie row by row and have equal sides. Page (i, j) is about the cells from (i, j) times its own
/// up to the next page's.
struct PageLayout {
    int columns = 1, rows = 1;
    int width = 0, height = 0;  ///< cells of a page, without its border

    int count() const { return columns * rows; }

    /// The cells that a page holds, with its border.
    grid::Rect cells(int page) const;

    /// The pages that hold any of these cells.
    std::vector<int> pages_of(const grid::Rect& cells) const;

    friend bool operator==(const PageLayout&, const PageLayout&) = default;
};

/// As few pages as hold the canvas, none with a side longer than `longest_side` texels.
PageLayout page_layout(const grid::Shape& canvas, int longest_side);

}  // namespace pastoso::screen

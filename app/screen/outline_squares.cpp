#include "screen/outline_squares.hpp"

#include "screen/page_layout.hpp"

#include <algorithm>

namespace pastoso::screen {
namespace {

using grid::Rect;

/// Cells along a square's side.
constexpr int kSquare = kOutlinePatch / 8;

}  // namespace

void OutlineSquares::reset(const grid::Shape& shape) {
    shape_ = shape;
    near_.assign(
        static_cast<std::size_t>(squares_x()) * ((shape.height + 2 * kLayerBorder) / kSquare + 1), 0);
}

void OutlineSquares::forget(const std::vector<int>& tiles) {
    for (const int tile : tiles)
        clear(outlined_by(shape_, tile));
}

int OutlineSquares::squares_x() const {
    return (shape_.width + 2 * kLayerBorder) / kSquare + 1;
}

/// A square holds the samples that begin two cells before its own.
char& OutlineSquares::square(int x, int y) {
    return near_[static_cast<std::size_t>((y + kLayerBorder) / kSquare) * squares_x() +
                 (x + kLayerBorder) / kSquare];
}

/// All squares that have a part in them.
void OutlineSquares::clear(const Rect& cells) {
    const auto first = [](int cell) { return (cell + kLayerBorder) / kSquare * kSquare - kLayerBorder; };
    for (int y = first(cells.y0); y < cells.y1; y += kSquare)
        for (int x = first(cells.x0); x < cells.x1; x += kSquare)
            square(x, y) = 0;
}

void OutlineSquares::note(const OutlinePatch& patch) {
    const Rect& cells = patch.cells;
    clear(cells);
    const OutlineTexel* texel = patch.outline.data();
    for (int y = cells.y0; y < cells.y1; ++y)
        for (int x = cells.x0; x < cells.x1; ++x, ++texel)
            if (texel->near > 0.0F) square(x, y) = 1;
}

std::vector<QRect> OutlineSquares::cells_near(const Rect& cells) const {
    std::vector<QRect> runs;
    for (int y = cells.y0 / kSquare; y * kSquare <= cells.y1; ++y) {
        const char* row = near_.data() + static_cast<std::size_t>(y) * squares_x();
        const int end = cells.x1 / kSquare + 1;
        for (int x = cells.x0 / kSquare; x < end;) {
            int beyond = x;
            while (beyond < end && row[beyond] != 0)
                ++beyond;
            if (beyond > x) runs.emplace_back(x * kSquare, y * kSquare, (beyond - x) * kSquare, kSquare);
            x = std::max(beyond, x + 1);
        }
    }
    return runs;
}

}  // namespace pastoso::screen

// The cells of a canvas and the square tiles they are stored in. x runs right, y down, both from 0; cell
// (x, y) covers [x, x+1) x [y, y+1) in cell units, its centre is at (x + 0.5, y + 0.5).
#pragma once

#include <algorithm>

namespace pastoso::grid {

inline constexpr int kTileSize = 64;
inline constexpr int kTileCells = kTileSize * kTileSize;

/// A half-open rectangle of cells or of tiles: x0 <= x < x1, y0 <= y < y1.
struct Rect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
    bool empty() const { return x1 <= x0 || y1 <= y0; }
    friend bool operator==(const Rect&, const Rect&) = default;
};

inline Rect intersection(const Rect& a, const Rect& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

/// The smallest rectangle that holds both; an empty one adds nothing.
inline Rect bounding_box(const Rect& a, const Rect& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

/// Width and height in cells, both at least 1, and the tiles they need; the last column and row of tiles
/// may reach beyond the canvas.
struct Shape {
    int width = 0, height = 0;

    int tiles_x() const { return (width + kTileSize - 1) / kTileSize; }
    int tiles_y() const { return (height + kTileSize - 1) / kTileSize; }
    int tile_count() const { return tiles_x() * tiles_y(); }
    Rect cells() const { return {0, 0, width, height}; }
    bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }

    /// The index of the tile that holds cell (x, y), and that of the cell within its tile.
    int tile_at(int x, int y) const { return (y / kTileSize) * tiles_x() + x / kTileSize; }
    static int cell_in_tile(int x, int y) { return (y % kTileSize) * kTileSize + x % kTileSize; }

    /// The cells of a tile that lie on the canvas.
    Rect tile_cells(int tile) const {
        const int x0 = (tile % tiles_x()) * kTileSize;
        const int y0 = (tile / tiles_x()) * kTileSize;
        return intersection(cells(), {x0, y0, x0 + kTileSize, y0 + kTileSize});
    }

    /// The tiles that a rectangle of cells touches, as a rectangle of tile columns and rows.
    Rect tiles_touching(const Rect& area) const {
        const Rect inside = intersection(area, cells());
        if (inside.empty()) return {};
        return {inside.x0 / kTileSize, inside.y0 / kTileSize, (inside.x1 - 1) / kTileSize + 1,
                (inside.y1 - 1) / kTileSize + 1};
    }

    friend bool operator==(const Shape&, const Shape&) = default;
};

}  // namespace pastoso::grid

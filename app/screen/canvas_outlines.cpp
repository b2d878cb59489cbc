#include "screen/canvas_outlines.hpp"

#include "screen/canvas_layers.hpp"
#include "screen/qt_rect.hpp"
#include "shade/cell_span.hpp"
#include "shade/outline_layers.hpp"

#include <algorithm>

namespace pastoso::screen {
namespace {

using grid::Rect;

/// Cells along a square's side.
constexpr int kSquare = 8;

/// Patches are squares of so many cells, a multiple of the small ones.
constexpr int kPatch = 8 * kSquare;

/// Cells from which paint reaches into the layers of another: shares, their gain, the samples that begin
/// there.
constexpr int kReach = 8;

Rect with_border(const grid::Shape& shape) {
    return shade::grown(shape.cells(), kLayerBorder);
}

/// The squares of the canvas's patches that `unknown` touches.
std::vector<Rect> patches_of(const QRegion& unknown, const grid::Shape& shape) {
    std::vector<Rect> patches;
    for (int y = -kLayerBorder; y < shape.height + kLayerBorder; y += kPatch)
        for (int x = -kLayerBorder; x < shape.width + kLayerBorder; x += kPatch)
            if (unknown.intersects(QRect(x, y, kPatch, kPatch)))
                patches.push_back(
                    grid::intersection(with_border(shape), {x, y, x + kPatch, y + kPatch}));
    return patches;
}

OutlinePatch patch_of(const document::Snapshot& shown, const Rect& cells,
                      const pigment::BandsToRgb& to_rgb) {
    shade::OutlineLayers told(cells);
    shade::tell_outline(shown.film, shown.ground, cells, to_rgb, told);
    const std::size_t count = told.share.size();
    OutlinePatch patch{cells, {}, {}};
    patch.outline.reserve(count);
    patch.dry.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const shade::CellColour& dry = told.dry[i];
        patch.outline.push_back(
            {told.cover[i], told.share[i], told.support_mm[i], static_cast<float>(told.near[i])});
        patch.dry.push_back({dry.red, dry.green, dry.blue, told.sharp[i]});
    }
    return patch;
}

}  // namespace

void CanvasOutlines::reset(const grid::Shape& shape) {
    shape_ = shape;
    near_squares_.assign(
        static_cast<std::size_t>(squares_x()) * ((shape.height + 2 * kLayerBorder) / kSquare + 1), 0);
    forget_all();
}

void CanvasOutlines::forget(const std::vector<int>& tiles) {
    for (const int tile : tiles)
        unknown_ += qt_rect(shade::grown(shape_.tile_cells(tile), kReach));
    unknown_ &= qt_rect(with_border(shape_));
}

void CanvasOutlines::forget_all() {
    unknown_ = qt_rect(with_border(shape_));
}

std::vector<OutlinePatch> CanvasOutlines::update(const document::Snapshot& shown, const Rect& cells,
                                                 const pigment::BandsToRgb& to_rgb,
                                                 core::ThreadPool& pool) {
    const std::vector<Rect> wanted =
        patches_of(unknown_ & qt_rect(shade::grown(cells, kLayerBorder)), shape_);
    std::vector<OutlinePatch> patches(wanted.size());
    pool.run(wanted.size(),
             [&](std::size_t i, int) { patches[i] = patch_of(shown, wanted[i], to_rgb); });
    for (const OutlinePatch& patch : patches) {
        unknown_ -= qt_rect(patch.cells);
        note_near(patch);
    }
    return patches;
}

int CanvasOutlines::squares_x() const {
    return (shape_.width + 2 * kLayerBorder) / kSquare + 1;
}

/// A square holds the samples that begin two cells before its own.
char& CanvasOutlines::near_square(int x, int y) {
    return near_squares_[static_cast<std::size_t>((y + kLayerBorder) / kSquare) * squares_x() +
                         (x + kLayerBorder) / kSquare];
}

void CanvasOutlines::note_near(const OutlinePatch& patch) {
    const Rect& cells = patch.cells;
    for (int y = cells.y0; y < cells.y1; y += kSquare)
        for (int x = cells.x0; x < cells.x1; x += kSquare)
            near_square(x, y) = 0;
    const OutlineTexel* texel = patch.outline.data();
    for (int y = cells.y0; y < cells.y1; ++y)
        for (int x = cells.x0; x < cells.x1; ++x, ++texel)
            if (texel->near > 0.0F) near_square(x, y) = 1;
}

std::vector<QRect> CanvasOutlines::cells_near(const Rect& cells) const {
    std::vector<QRect> runs;
    for (int y = cells.y0 / kSquare; y * kSquare <= cells.y1; ++y) {
        const char* row = near_squares_.data() + static_cast<std::size_t>(y) * squares_x();
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

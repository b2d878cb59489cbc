#include "screen/canvas_outlines.hpp"

#include "screen/canvas_layers.hpp"
#include "screen/qt_rect.hpp"
#include "shade/cell_span.hpp"
#include "shade/outline_layers.hpp"

#include <algorithm>

namespace pastoso::screen {
namespace {

using grid::Rect;

/// Cells from which paint reaches into the layers of another: shares, their gain, the samples that begin
/// there.
constexpr int kReach = 8;

Rect with_border(const grid::Shape& shape) {
    return shade::grown(shape.cells(), kLayerBorder);
}

/// The squares of the canvas's patches that `unknown` touches.
std::vector<Rect> patches_of(const QRegion& unknown, const grid::Shape& shape) {
    std::vector<Rect> patches;
    for (int y = -kLayerBorder; y < shape.height + kLayerBorder; y += kOutlinePatch)
        for (int x = -kLayerBorder; x < shape.width + kLayerBorder; x += kOutlinePatch)
            if (unknown.intersects(QRect(x, y, kOutlinePatch, kOutlinePatch)))
                patches.push_back(grid::intersection(with_border(shape),
                                                     {x, y, x + kOutlinePatch, y + kOutlinePatch}));
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

Rect outlined_by(const grid::Shape& shape, int tile) {
    return grid::intersection(with_border(shape), shade::grown(shape.tile_cells(tile), kReach));
}

void CanvasOutlines::reset(const grid::Shape& shape) {
    shape_ = shape;
    forget_all();
}

void CanvasOutlines::forget(const std::vector<int>& tiles) {
    for (const int tile : tiles)
        unknown_ += qt_rect(outlined_by(shape_, tile));
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
    for (const OutlinePatch& patch : patches)
        unknown_ -= qt_rect(patch.cells);
    return patches;
}

}  // namespace pastoso::screen

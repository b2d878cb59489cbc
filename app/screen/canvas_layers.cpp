#include "screen/canvas_layers.hpp"

#include "core/units.hpp"
#include "grid/bspline.hpp"
#include "screen/qt_rect.hpp"
#include "shade/cell_span.hpp"
#include "shade/shadow.hpp"
#include "shade/sky.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::screen {
namespace {

using grid::Rect;

/// Work is cut into bands of this many rows for the threads.
constexpr int kBandRows = 32;

std::vector<Rect> bands(const QRegion& region) {
    std::vector<Rect> parts;
    for (const QRect& rect : region) {
        const Rect whole = cell_rect(rect);
        for (int y = whole.y0; y < whole.y1; y += kBandRows) {
            parts.push_back({whole.x0, y, whole.x1, std::min(y + kBandRows, whole.y1)});
        }
    }
    return parts;
}

ColourPatch colour_patch(const document::Snapshot& snapshot, int tile,
                         const pigment::BandsToRgb& to_rgb) {
    ColourPatch patch{tile_with_border(snapshot.film.shape, tile), {}};
    patch.colours.resize(static_cast<std::size_t>(patch.cells.width()) * patch.cells.height());
    shade::cell_colours(snapshot.film, patch.cells, snapshot.ground, patch.colours.data(),
                        patch.cells.width(), to_rgb);
    return patch;
}

}  // namespace

Rect tile_with_border(const grid::Shape& shape, int tile) {
    Rect cells = shape.tile_cells(tile);
    if (cells.x0 == 0) cells.x0 -= kLayerBorder;
    if (cells.y0 == 0) cells.y0 -= kLayerBorder;
    if (cells.x1 == shape.width) cells.x1 += kLayerBorder;
    if (cells.y1 == shape.height) cells.y1 += kLayerBorder;
    return cells;
}

std::vector<int> changed_tiles(const document::Snapshot* shown, const document::Snapshot& next) {
    std::vector<int> tiles;
    const film::FilmState& film = next.film;
    for (int tile = 0; tile < film.shape.tile_count(); ++tile) {
        if (shown != nullptr && film.thickness.shares_tile(shown->film.thickness, tile) &&
            film.paint.shares_tile(shown->film.paint, tile) &&
            film.lower.paint.shares_tile(shown->film.lower.paint, tile) &&
            film.support_mm.shares_tile(shown->film.support_mm, tile) &&
            film.strata.optics.shares_tile(shown->film.strata.optics, tile)) {
            continue;
        }
        tiles.push_back(tile);
    }
    return tiles;
}

QRegion relief_region(const film::FilmState& film, const std::vector<int>& tiles,
                      const shade::Lighting& lighting, const shade::HeightRange& range, int beyond) {
    const int around = std::max(grid::kPrefilterReach, shade::sky_reach_cells(film.cell_mm));
    const double shadow_cells = (range.highest_mm - range.lowest_mm) /
                                (film.cell_mm * std::tan(core::radians(lighting.elevation_deg)));
    const double azimuth = core::radians(lighting.azimuth_deg);
    const int shadow_x = static_cast<int>(std::lround(-shadow_cells * std::cos(azimuth)));
    const int shadow_y = static_cast<int>(std::lround(shadow_cells * std::sin(azimuth)));
    QRegion region;
    for (const int tile : tiles) {
        const QRect cells =
            qt_rect(film.shape.tile_cells(tile)).adjusted(-around, -around, around, around);
        region += cells.united(cells.translated(shadow_x, shadow_y));
    }
    return region & qt_rect(shade::grown(film.shape.cells(), beyond));
}

Rect CanvasLayers::cells_with_border() const {
    return shade::grown(shape_.cells(), kLayerBorder);
}

std::vector<SurfacePatch> CanvasLayers::patches(const QRegion& cells) const {
    std::vector<SurfacePatch> patches;
    for (const Rect& part : bands(cells)) {
        SurfacePatch& patch = patches.emplace_back(SurfacePatch{part, {}});
        patch.texels.reserve(static_cast<std::size_t>(part.width()) * part.height());
        for (int y = part.y0; y < part.y1; ++y) {
            const SurfaceTexel* row = surface(part.x0, y);
            patch.texels.insert(patch.texels.end(), row, row + part.width());
        }
    }
    return patches;
}

void CanvasLayers::reset(const grid::Shape& shape) {
    shape_ = shape;
    range_ = {};
    surface_.assign(static_cast<std::size_t>(stride()) * (shape.height + 2 * kLayerBorder),
                    SurfaceTexel{});
}

LayerChanges CanvasLayers::update(const document::Snapshot* shown, const document::Snapshot& next,
                                  const shade::Lighting& lighting, core::ThreadPool& pool,
                                  const pigment::BandsToRgb& to_rgb) {
    if (shown == nullptr) reset(next.film.shape);
    const std::vector<int> tiles = changed_tiles(shown, next);
    LayerChanges changes;
    if (tiles.empty()) return changes;
    changes.tiles = tiles;
    const shade::HeightRange range_before = range_;
    ranges_.update(next.film, tiles);
    range_ = ranges_.all();
    changes.surface =
        relief_region(next.film, tiles, lighting, united(range_before, range_), kLayerBorder);
    changes.colours.resize(tiles.size());
    const std::vector<Rect> parts = bands(changes.surface);
    pool.run(parts.size() + tiles.size(), [&](std::size_t job, int) {
        if (job < parts.size()) {
            fill_surface(next.film, parts[job]);
            fill_shadow(next.film, parts[job], lighting);
        } else {
            const std::size_t i = job - parts.size();
            changes.colours[i] = colour_patch(next, tiles[i], to_rgb);
        }
    });
    return changes;
}

void CanvasLayers::relight(const document::Snapshot& shown, const shade::Lighting& lighting,
                           core::ThreadPool& pool) {
    const std::vector<Rect> parts = bands(qt_rect(cells_with_border()));
    pool.run(parts.size(), [&](std::size_t i, int) { fill_shadow(shown.film, parts[i], lighting); });
}

std::vector<ColourPatch> CanvasLayers::recolour(const document::Snapshot& shown,
                                                const pigment::BandsToRgb& to_rgb,
                                                core::ThreadPool& pool) {
    std::vector<ColourPatch> patches(static_cast<std::size_t>(shown.film.shape.tile_count()));
    pool.run(patches.size(), [&](std::size_t tile, int) {
        patches[tile] = colour_patch(shown, static_cast<int>(tile), to_rgb);
    });
    return patches;
}

void CanvasLayers::fill_surface(const film::FilmState& film, const Rect& cells) {
    const std::size_t count = static_cast<std::size_t>(cells.width()) * cells.height();
    std::vector<float> height_mm(count);
    std::vector<float> sky(count);
    shade::height_coefficients(film, cells, height_mm.data(), cells.width());
    shade::sky_shares(film, cells, sky.data(), cells.width());
    std::size_t from = 0;
    for (int y = cells.y0; y < cells.y1; ++y) {
        SurfaceTexel* row = surface_.data() + index(cells.x0, y);
        for (int x = 0; x < cells.width(); ++x, ++from) {
            row[x].height_mm = height_mm[from];
            row[x].sky = sky[from];
        }
    }
}

void CanvasLayers::fill_shadow(const film::FilmState& film, const Rect& cells,
                               const shade::Lighting& lighting) {
    std::vector<float> shadow_mm(static_cast<std::size_t>(cells.width()) * cells.height());
    shade::shadow_heights(film, cells, lighting, range_, shadow_mm.data(), cells.width());
    std::size_t from = 0;
    for (int y = cells.y0; y < cells.y1; ++y) {
        SurfaceTexel* row = surface_.data() + index(cells.x0, y);
        for (int x = 0; x < cells.width(); ++x, ++from)
            row[x].shadow_mm = shadow_mm[from];
    }
}

}  // namespace pastoso::screen

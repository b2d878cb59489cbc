#include "shade/cell_layers.hpp"

#include "shade/shadow.hpp"
#include "shade/sky.hpp"

#include <algorithm>

namespace pastoso::shade {
namespace {

using grid::Rect;

constexpr int kBandRows = 64;

void fill_band(const film::FilmState& film, const pigment::Bands& ground, const Rect& band,
               const pigment::BandsToRgb& to_rgb, const Lighting& lighting, const HeightRange& range,
               CellLayers& layers) {
    const std::ptrdiff_t first = layers.index(band.x0, band.y0);
    const int stride = layers.cells.width();
    height_coefficients(film, band, layers.height_mm.data() + first, stride);
    shadow_heights(film, band, lighting, range, layers.shadow_mm.data() + first, stride);
    sky_shares(film, band, layers.sky.data() + first, stride);
    cell_colours(film, band, ground, layers.colour.data() + first, stride, to_rgb);
}

}  // namespace

std::vector<Rect> bands_of(const Rect& cells) {
    std::vector<Rect> bands;
    for (int y = cells.y0; y < cells.y1; y += kBandRows) {
        bands.push_back({cells.x0, y, cells.x1, std::min(y + kBandRows, cells.y1)});
    }
    return bands;
}

LayerRows CellLayers::rows_from(int first_row) const {
    LayerRows rows;
    for (int k = 0; k < 4; ++k) {
        const std::ptrdiff_t row = index(cells.x0, cells.y0 + first_row + k);
        rows.height[k] = height_mm.data() + row;
        rows.shadow[k] = shadow_mm.data() + row;
        rows.sky[k] = sky.data() + row;
        rows.colour[k] = colour.data() + row;
    }
    return rows;
}

CellLayers cell_layers(const film::FilmState& film, const pigment::Bands& ground,
                       const grid::Rect& cells, const Lighting& lighting, const HeightRange& range,
                       core::ThreadPool& pool, const pigment::BandsToRgb& to_rgb) {
    CellLayers layers;
    layers.cells = cells;
    const std::size_t count = static_cast<std::size_t>(cells.width()) * cells.height();
    layers.height_mm.resize(count);
    layers.shadow_mm.resize(count);
    layers.sky.resize(count);
    layers.colour.resize(count);
    const std::vector<Rect> bands = bands_of(cells);
    pool.run(bands.size(), [&](std::size_t index, int) {
        fill_band(film, ground, bands[index], to_rgb, lighting, range, layers);
    });
    return layers;
}

CellLayers cell_layers(const film::FilmState& film, const pigment::Bands& ground,
                       const grid::Rect& cells, const Lighting& lighting, core::ThreadPool& pool,
                       const pigment::BandsToRgb& to_rgb) {
    return cell_layers(film, ground, cells, lighting, surface_range(film), pool, to_rgb);
}

}  // namespace pastoso::shade

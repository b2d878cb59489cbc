#include "shade/cell_layers.hpp"

#include "core/check.hpp"
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

CellLayers::CellLayers(const Rect& rectangle) : cells(rectangle) {
    const std::size_t count = static_cast<std::size_t>(cells.width()) * cells.height();
    height_mm.resize(count);
    shadow_mm.resize(count);
    sky.resize(count);
    colour.resize(count);
}

void fill_layers(const film::FilmState& film, const pigment::Bands& ground,
                 const std::vector<Rect>& parts, const Lighting& lighting, const HeightRange& range,
                 core::ThreadPool& pool, const pigment::BandsToRgb& to_rgb, CellLayers& layers) {
    std::vector<Rect> bands;
    for (const Rect& part : parts) {
        const std::vector<Rect> of_part = bands_of(part);
        bands.insert(bands.end(), of_part.begin(), of_part.end());
    }
    pool.run(bands.size(), [&](std::size_t index, int) {
        fill_band(film, ground, bands[index], to_rgb, lighting, range, layers);
    });
}

CellLayers part_of(const CellLayers& layers, const Rect& cells) {
    PASTOSO_CHECK(grid::intersection(layers.cells, cells) == cells);
    CellLayers part(cells);
    for (int y = cells.y0; y < cells.y1; ++y) {
        const std::ptrdiff_t from = layers.index(cells.x0, y), to = part.index(cells.x0, y);
        std::copy_n(layers.height_mm.begin() + from, cells.width(), part.height_mm.begin() + to);
        std::copy_n(layers.shadow_mm.begin() + from, cells.width(), part.shadow_mm.begin() + to);
        std::copy_n(layers.sky.begin() + from, cells.width(), part.sky.begin() + to);
        std::copy_n(layers.colour.begin() + from, cells.width(), part.colour.begin() + to);
    }
    return part;
}

CellLayers cell_layers(const film::FilmState& film, const pigment::Bands& ground,
                       const grid::Rect& cells, const Lighting& lighting, const HeightRange& range,
                       core::ThreadPool& pool, const pigment::BandsToRgb& to_rgb) {
    CellLayers layers(cells);
    fill_layers(film, ground, {cells}, lighting, range, pool, to_rgb, layers);
    return layers;
}

CellLayers cell_layers(const film::FilmState& film, const pigment::Bands& ground,
                       const grid::Rect& cells, const Lighting& lighting, core::ThreadPool& pool,
                       const pigment::BandsToRgb& to_rgb) {
    return cell_layers(film, ground, cells, lighting, surface_range(film), pool, to_rgb);
}

}  // namespace pastoso::shade

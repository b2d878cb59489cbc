#include "shade/outline_layers.hpp"

#include "shade/outline.hpp"

namespace pastoso::shade {
namespace {

using grid::Rect;

void fill_band(const film::FilmState& film, const pigment::Bands& ground, const Rect& band,
               const CellLayers& layers, const pigment::BandsToRgb& to_rgb, OutlineLayers& outline) {
    const std::ptrdiff_t first = layers.index(band.x0, band.y0);
    const int stride = layers.cells.width();
    outline_cells(
        film, band,
        {outline.share.data() + first, outline.cover.data() + first, outline.near.data() + first},
        stride);
    edge_sharpness(film, band, outline.sharp.data() + first, stride);
    support_coefficients(film, band, outline.support_mm.data() + first, stride);
    dry_colours(film, band, ground, outline.dry.data() + first, stride, to_rgb);
    const std::ptrdiff_t end = first + static_cast<std::ptrdiff_t>(band.height()) * stride;
    for (std::ptrdiff_t i = first; i < end; ++i) {
        const CellColour& colour = layers.colour[i];
        const float share = outline.share[i];
        outline.sharp[i] *= share;
        outline.covered[i] = {share * colour.red, share * colour.green, share * colour.blue,
                              share * colour.wetness};
    }
}

}  // namespace

OutlineRows OutlineLayers::rows_from(int first_row) const {
    OutlineRows rows;
    for (int k = 0; k < 4; ++k) {
        const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(first_row + k) * cells.width();
        rows.share[k] = share.data() + row;
        rows.sharp[k] = sharp.data() + row;
        rows.cover[k] = cover.data() + row;
        rows.support[k] = support_mm.data() + row;
        rows.covered[k] = covered.data() + row;
        rows.dry[k] = dry.data() + row;
    }
    rows.near = near.data() + static_cast<std::ptrdiff_t>(first_row) * cells.width();
    return rows;
}

OutlineLayers outline_layers(const film::FilmState& film, const pigment::Bands& ground,
                             const CellLayers& layers, core::ThreadPool& pool,
                             const pigment::BandsToRgb& to_rgb) {
    OutlineLayers outline;
    outline.cells = layers.cells;
    const std::size_t count = layers.colour.size();
    outline.share.resize(count);
    outline.cover.resize(count);
    outline.near.resize(count);
    outline.sharp.resize(count);
    outline.support_mm.resize(count);
    outline.covered.resize(count);
    outline.dry.resize(count);
    const std::vector<Rect> bands = bands_of(layers.cells);
    pool.run(bands.size(), [&](std::size_t index, int) {
        fill_band(film, ground, bands[index], layers, to_rgb, outline);
    });
    return outline;
}

}  // namespace pastoso::shade

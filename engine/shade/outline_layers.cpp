#include "shade/outline_layers.hpp"

#include "shade/outline.hpp"

namespace pastoso::shade {
namespace {

using grid::Rect;

/// The cell's colour as far as it is covered.
void weigh_colours(const CellLayers& layers, const Rect& band, OutlineLayers& outline) {
    const std::ptrdiff_t first = layers.index(band.x0, band.y0);
    const std::ptrdiff_t end = first + static_cast<std::ptrdiff_t>(band.height()) * layers.cells.width();
    for (std::ptrdiff_t i = first; i < end; ++i) {
        const CellColour& colour = layers.colour[i];
        const float share = outline.share[i];
        outline.covered[i] = {share * colour.red, share * colour.green, share * colour.blue,
                              share * colour.wetness};
    }
}

}  // namespace

OutlineLayers::OutlineLayers(const Rect& wanted) : cells(wanted) {
    const std::size_t count = static_cast<std::size_t>(cells.width()) * cells.height();
    share.resize(count);
    cover.resize(count);
    near.resize(count);
    sharp.resize(count);
    support_mm.resize(count);
    dry.resize(count);
}

void tell_outline(const film::FilmState& film, const pigment::Bands& ground, const Rect& part,
                  const pigment::BandsToRgb& to_rgb, OutlineLayers& outline) {
    const int stride = outline.cells.width();
    const std::ptrdiff_t first =
        static_cast<std::ptrdiff_t>(part.y0 - outline.cells.y0) * stride + part.x0 - outline.cells.x0;
    outline_cells(
        film, part,
        {outline.share.data() + first, outline.cover.data() + first, outline.near.data() + first},
        stride);
    edge_sharpness(film, part, outline.sharp.data() + first, stride);
    support_coefficients(film, part, outline.support_mm.data() + first, stride);
    dry_colours(film, part, ground, outline.dry.data() + first, stride, to_rgb);
    for (int y = 0; y < part.height(); ++y)
        for (std::ptrdiff_t i = first + static_cast<std::ptrdiff_t>(y) * stride, end = i + part.width();
             i < end; ++i)
            outline.sharp[i] *= outline.share[i];
}

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
    OutlineLayers outline(layers.cells);
    outline.covered.resize(layers.colour.size());
    const std::vector<Rect> bands = bands_of(layers.cells);
    pool.run(bands.size(), [&](std::size_t index, int) {
        tell_outline(film, ground, bands[index], to_rgb, outline);
        weigh_colours(layers, bands[index], outline);
    });
    return outline;
}

}  // namespace pastoso::shade

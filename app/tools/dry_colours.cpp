#include "tools/dry_colours.hpp"

#include "core/check.hpp"
#include "document/layered_canvas.hpp"
#include "document/masking.hpp"

#include <vector>

namespace pastoso::tools {
namespace {

layers::DrySample sample_of(const document::Snapshot& painting) {
    const document::LayerStack& stack = *painting.layers;
    const film::FilmState& active = painting.active ? *painting.active : painting.film;
    const auto layers = document::layers_apart(active, painting.bare->support_mm, stack);
    const document::Selection where = document::without_masked(painting.selection, painting.masking);
    return layers::dry_sample(*layers[stack.active], where.get());
}

pigment::Srgb8 mean_colour(const film::FilmState& film, int count, const shade::Spot& spot) {
    std::vector<shade::CellColour> colours(grid::kTileCells);
    shade::dry_colours(film, film.shape.tile_cells(0), spot.ground, colours.data(), grid::kTileSize,
                       spot.viewing.to_rgb);
    double red = 0.0, green = 0.0, blue = 0.0;
    for (int cell = 0; cell < count; ++cell) {
        const shade::CellColour& colour = colours[static_cast<std::size_t>(cell)];
        red += colour.red;
        green += colour.green;
        blue += colour.blue;
    }
    return shade::lit_colour({.red = static_cast<float>(red / count),
                              .green = static_cast<float>(green / count),
                              .blue = static_cast<float>(blue / count)},
                             spot);
}

}  // namespace

DryColours::DryColours(const document::Snapshot& painting) : sample_(sample_of(painting)) {}

AdjustedColours DryColours::adjusted(const film::PaintCoefficients& paint,
                                     const layers::Adjustment& adjustment,
                                     const shade::Spot& spot) const {
    PASTOSO_CHECK(any());
    const pigment::Srgb8 before = mean_colour(sample_.film, sample_.count, spot);
    if (!layers::can_lie_dry(paint)) return {before, before};
    core::ThreadPool alone(1);
    const film::FilmState after = layers::adjusted(sample_.film, paint, adjustment, nullptr, alone).film;
    return {before, mean_colour(after, sample_.count, spot)};
}

}  // namespace pastoso::tools

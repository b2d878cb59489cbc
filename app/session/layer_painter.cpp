#include "session/layer_painter.hpp"

#include "pigment/appearance.hpp"
#include "pigment/hex_colour.hpp"
#include "session/small_picture.hpp"
#include "shade/tile_colour.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace pastoso::session {
namespace {

bool is_covered(const film::FilmState& film, int x, int y) {
    return film.thickness.at(x, y) > 0 || film.strata.soluble_thickness.at(x, y) > 0 ||
           film.strata.optics.at(x, y) != film::kClearStrata;
}

std::array<std::uint8_t, 4> pixel_of(const film::FilmState& film, const grid::Rect& cells,
                                     const pigment::Bands& ground) {
    std::array<shade::CellColour, kMostCells * kMostCells> colours;
    shade::cell_colours(film, cells, ground, colours.data(), kMostCells);
    pigment::LinearRgb sum{};
    int covered = 0;
    for (int y = cells.y0; y < cells.y1; ++y) {
        for (int x = cells.x0; x < cells.x1; ++x) {
            const shade::CellColour& colour = colours[(y - cells.y0) * kMostCells + x - cells.x0];
            if (!is_covered(film, x, y)) continue;
            sum[0] += colour.red;
            sum[1] += colour.green;
            sum[2] += colour.blue;
            ++covered;
        }
    }
    if (covered == 0) return {};
    for (auto& channel : sum)
        channel /= covered;
    const pigment::Srgb8 rgb = pigment::encoded(pigment::screen_colour(sum));
    const int all = cells.width() * cells.height();
    return {rgb[0], rgb[1], rgb[2], static_cast<std::uint8_t>(255 * covered / all)};
}

}  // namespace

LayerPicture layer_picture(const film::FilmState& layer, const pigment::Bands& ground, int most_width,
                           int most_height) {
    const PictureSize size = size_within(layer.shape, most_width, most_height);
    LayerPicture picture{size.width, size.height, {}, film::has_wet_paint(layer)};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const auto pixel = pixel_of(layer, cells_of_pixel(x, y, size, layer.shape), ground);
            picture.rgba.insert(picture.rgba.end(), pixel.begin(), pixel.end());
        }
    }
    return picture;
}

LayerPainter::LayerPainter(int most_width, int most_height, Deliver deliver, core::Tell tell)
    : worker_(
          [most_width, most_height, deliver = std::move(deliver)](Wanted& wanted) {
              deliver(wanted.layer, layer_picture(*wanted.film, wanted.ground, most_width, most_height));
          },
          [tell = std::move(tell)](Wanted&, const core::Message& fault) { tell(fault); }) {}

void LayerPainter::want(document::LayerId layer, std::shared_ptr<const film::FilmState> film,
                        const pigment::Bands& ground) {
    worker_.change([&](std::deque<Wanted>& waiting) {
        std::erase_if(waiting, [&](const Wanted& wanted) { return wanted.layer == layer; });
        waiting.push_back({layer, std::move(film), ground});
    });
}

}  // namespace pastoso::session

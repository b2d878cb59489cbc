#include "session/overview.hpp"

#include "pigment/hex_colour.hpp"
#include "shade/tile_colour.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace pastoso::session {
namespace {

pigment::Srgb8 pixel_of(const OverviewSubject& subject, const grid::Rect& cells) {
    std::array<shade::CellColour, kMostCells * kMostCells> colours;
    shade::cell_colours(*subject.film, cells, subject.ground, colours.data(), kMostCells,
                        subject.viewing.to_rgb);
    pigment::LinearRgb sum{};
    for (int y = 0; y < cells.height(); ++y) {
        for (int x = 0; x < cells.width(); ++x) {
            const shade::CellColour& colour = colours[y * kMostCells + x];
            sum[0] += colour.red;
            sum[1] += colour.green;
            sum[2] += colour.blue;
        }
    }
    const auto count = static_cast<float>(cells.width() * cells.height());
    for (float& channel : sum)
        channel /= count;
    return pigment::encoded(pigment::into_gamut(sum, subject.viewing.space));
}

/// Whether a pixel of these cells, which may lie on four tiles, shows one that has changed.
bool shows_change(const grid::Rect& cells, const grid::Shape& canvas, const std::vector<bool>& changed) {
    return changed[canvas.tile_at(cells.x0, cells.y0)] ||
           changed[canvas.tile_at(cells.x1 - 1, cells.y0)] ||
           changed[canvas.tile_at(cells.x0, cells.y1 - 1)] ||
           changed[canvas.tile_at(cells.x1 - 1, cells.y1 - 1)];
}

}  // namespace

/// Whether the picture is that of another canvas, or in another light, than the one before.
bool Overview::begin(const OverviewSubject& subject) {
    const grid::Shape& canvas = subject.film->shape;
    if (!picture_.rgb.empty() && canvas == canvas_ && subject.viewing == viewing_) return false;
    canvas_ = canvas;
    viewing_ = subject.viewing;
    const PictureSize size = size_within(canvas, most_width_, most_height_);
    picture_ = {size.width, size.height, {}, viewing_.space};
    picture_.rgb.resize(std::size_t{3} * size.width * size.height);
    return true;
}

const pigment::Image8& Overview::update(const OverviewSubject& subject) {
    std::vector<bool> changed(static_cast<std::size_t>(subject.film->shape.tile_count()),
                              begin(subject));
    for (const int tile : subject.tiles)
        changed[tile] = true;
    const PictureSize size{picture_.width, picture_.height};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const grid::Rect cells = cells_of_pixel(x, y, size, canvas_);
            if (!shows_change(cells, canvas_, changed)) continue;
            const pigment::Srgb8 rgb = pixel_of(subject, cells);
            std::copy(rgb.begin(), rgb.end(),
                      picture_.rgb.begin() + 3 * (std::ptrdiff_t{y} * size.width + x));
        }
    }
    return picture_;
}

OverviewPainter::OverviewPainter(int most_width, int most_height, Deliver deliver, core::Tell tell)
    : overview_(most_width, most_height),
      worker_([this, deliver = std::move(deliver)](
                  OverviewSubject& subject) { deliver(overview_.update(subject)); },
              [tell = std::move(tell)](OverviewSubject&, const core::Message& fault) { tell(fault); }) {}

void OverviewPainter::want(OverviewSubject subject) {
    worker_.change([&](std::deque<OverviewSubject>& waiting) {
        // Tiles of another canvas say nothing of this one, which is painted whole.
        for (const OverviewSubject& earlier : waiting)
            if (earlier.film->shape == subject.film->shape)
                subject.tiles.insert(subject.tiles.end(), earlier.tiles.begin(), earlier.tiles.end());
        waiting.clear();
        waiting.push_back(std::move(subject));
    });
}

}  // namespace pastoso::session

#include "tools/canvas_colour.hpp"

#include "pigment/appearance.hpp"
#include "shade/tile_colour.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pastoso::tools {

std::optional<pigment::Srgb8> colour_at(const document::Snapshot& snapshot, double x_mm, double y_mm) {
    constexpr int kSide = 3;
    const grid::Shape& shape = snapshot.film.shape;
    const double cell_mm = snapshot.film.cell_mm;
    const bool inside =
        x_mm >= 0.0 && y_mm >= 0.0 && x_mm < shape.width * cell_mm && y_mm < shape.height * cell_mm;
    if (!inside || shape.width < kSide || shape.height < kSide) return std::nullopt;
    const int x0 = std::clamp(static_cast<int>(x_mm / cell_mm) - 1, 0, shape.width - kSide);
    const int y0 = std::clamp(static_cast<int>(y_mm / cell_mm) - 1, 0, shape.height - kSide);
    std::array<shade::CellColour, kSide * kSide> cells;
    shade::cell_colours(snapshot.film, {x0, y0, x0 + kSide, y0 + kSide}, snapshot.ground, cells.data(),
                        kSide);
    pigment::LinearRgb sum{};
    for (const shade::CellColour& cell : cells) {
        sum[0] += cell.red / cells.size();
        sum[1] += cell.green / cells.size();
        sum[2] += cell.blue / cells.size();
    }
    return pigment::encoded(pigment::screen_colour(sum));
}

}  // namespace pastoso::tools

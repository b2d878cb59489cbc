#include "layers/picture_means.hpp"
#include "layers/texture/texture_heights.hpp"

namespace pastoso::layers {
namespace {

/// Of how much of its greatest height a pixel stands, 0 to 1.
double raised(const std::uint8_t* pixel, bool dark_raised) {
    const double grey = (0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2]) / 255.0;
    return (dark_raised ? 1.0 - grey : grey) * pixel[3] / 255.0;
}

double mean(const PressedTexture& pressed, const AxisCover& column, const AxisCover& row) {
    const pigment::Picture& picture = *pressed.picture;
    double sum = 0.0;
    for (std::size_t j = 0; j < row.weights.size(); ++j) {
        const std::size_t start =
            (static_cast<std::size_t>(row.first) + j) * picture.width + column.first;
        for (std::size_t i = 0; i < column.weights.size(); ++i)
            sum += row.weights[j] * column.weights[i] *
                   raised(&picture.rgba[4 * (start + i)], pressed.dark_raised);
    }
    return sum * column.share * row.share;
}

}  // namespace

CellHeights pressed_heights(const PressedTexture& pressed, const grid::Rect& cells, double cell_mm) {
    const PicturePlace& place = pressed.place;
    const std::vector<AxisCover> columns = axis_covers(place.x_mm / cell_mm, place.width_mm / cell_mm,
                                                       pressed.picture->width, cells.x0, cells.x1);
    const std::vector<AxisCover> rows = axis_covers(place.y_mm / cell_mm, place.height_mm / cell_mm,
                                                    pressed.picture->height, cells.y0, cells.y1);
    CellHeights heights;
    heights.reserve(columns.size() * rows.size());
    for (const AxisCover& row : rows)
        for (const AxisCover& column : columns)
            heights.push_back(static_cast<float>(pressed.height_mm * mean(pressed, column, row)));
    return heights;
}

}  // namespace pastoso::layers

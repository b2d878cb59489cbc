#include "session/small_picture.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace pastoso::session {
namespace {

/// Along one side: first and one past the last.
std::pair<int, int> cells_of(int pixel, int pixels, int cells) {
    const auto edge = [&](int number) {
        return static_cast<int>(static_cast<std::int64_t>(number) * cells / pixels);
    };
    const int first = std::min(edge(pixel), cells - 1);
    return {first, std::clamp(edge(pixel + 1), first + 1, first + kMostCells)};
}

}  // namespace

PictureSize size_within(const grid::Shape& canvas, int most_width, int most_height) {
    const double scale = std::min(static_cast<double>(most_width) / canvas.width,
                                  static_cast<double>(most_height) / canvas.height);
    return {std::max(1, static_cast<int>(canvas.width * scale)),
            std::max(1, static_cast<int>(canvas.height * scale))};
}

grid::Rect cells_of_pixel(int x, int y, const PictureSize& picture, const grid::Shape& canvas) {
    const auto [x0, x1] = cells_of(x, picture.width, canvas.width);
    const auto [y0, y1] = cells_of(y, picture.height, canvas.height);
    return {x0, y0, x1, y1};
}

}  // namespace pastoso::session

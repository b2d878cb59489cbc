#include "files/upright.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::files {

pigment::Picture upright(pigment::Picture picture, int orientation) {
    if (orientation < 2 || orientation > 8) return picture;
    const bool rows_are_columns = orientation > 4;
    const bool from_right = orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
    const bool from_bottom =
        orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
    pigment::Picture turned{picture.width, picture.height, {}};
    if (rows_are_columns) std::swap(turned.width, turned.height);
    turned.rgba.resize(picture.rgba.size());
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            int to_x = rows_are_columns ? y : x, to_y = rows_are_columns ? x : y;
            if (from_right) to_x = turned.width - 1 - to_x;
            if (from_bottom) to_y = turned.height - 1 - to_y;
            std::copy_n(&picture.rgba[std::size_t{4} * (std::size_t{1} * y * picture.width + x)], 4,
                        &turned.rgba[std::size_t{4} * (std::size_t{1} * to_y * turned.width + to_x)]);
        }
    }
    return turned;
}

}  // namespace pastoso::files

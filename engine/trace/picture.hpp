// A traced picture, row by row from the top, three floats a pixel: linear sRGB.
#pragma once

#include <cstddef>
#include <vector>

namespace pastoso::trace {

struct Picture {
    int width = 0, height = 0;
    std::vector<float> rgb;

    Picture() = default;
    Picture(int columns, int rows)
        : width(columns),
          height(rows),
          rgb(3 * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}
    const float* at(int x, int y) const {
        return rgb.data() + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                 static_cast<std::size_t>(x));
    }
    friend bool operator==(const Picture&, const Picture&) = default;
};

/// What a screen shall show of scene radiance, in linear light from 0 to 1: exposure 0.95 and the curve
/// 1.25 v (1 + 0.12 v) / (1 + 0.55 v), which keeps white things below the screen's white, clipped.
Picture toned(const Picture& radiance);

}  // namespace pastoso::trace

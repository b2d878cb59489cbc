// A choice of cells as text.
#pragma once

#include "grid/mask.hpp"

#include <string>

namespace pastoso::grid {

/// Rows of # for chosen cells and . for others.
inline std::string drawn(const Mask& mask) {
    std::string text;
    for (int y = 0; y < mask.shape().height; ++y) {
        for (int x = 0; x < mask.shape().width; ++x)
            text += mask.at(x, y) != 0 ? '#' : '.';
        text += '\n';
    }
    return text;
}

}  // namespace pastoso::grid

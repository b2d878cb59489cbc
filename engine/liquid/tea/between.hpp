// Where a place lies between two neighbours along an axis: one axis of a linear interpolation.
#pragma once

#include <cmath>

namespace pastoso::liquid {

/// The lower of two neighbours and how far on to the upper one, 0 to 1.
struct Between {
    int lower;
    float part;
};

inline Between between(float place) {
    const float lower = std::floor(place);
    return {static_cast<int>(lower), place - lower};
}

/// Of a place in cells, between the middles of cells.
inline Between between_middles(float place_cells) {
    return between(place_cells - 0.5F);
}

}  // namespace pastoso::liquid

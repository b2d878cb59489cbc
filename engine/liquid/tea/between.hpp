// Where a place lies between two neighbours along an axis: one axis of a linear interpolation.
#pragma once

namespace pastoso::liquid {

/// The lower of two neighbours and how far on to the upper one, 0 to 1.
struct Between {
    int lower;
    float part;
};

/// Of places within 2^31.
inline Between between(float place) {
    // The floor by hand: a call where the processor may lack the instruction.
    const int toward_zero = static_cast<int>(place);
    const int lower = toward_zero - (place < static_cast<float>(toward_zero) ? 1 : 0);
    return {lower, place - static_cast<float>(lower)};
}

/// Of a place in cells, between the middles of cells.
inline Between between_middles(float place_cells) {
    return between(place_cells - 0.5F);
}

}  // namespace pastoso::liquid

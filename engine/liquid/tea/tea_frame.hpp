// The tea at one moment: all that is needed to draw it.
#pragma once

#include "grid/box_field.hpp"
#include "liquid/tea/milk_stream.hpp"
#include "liquid/tea/parcel.hpp"

#include <vector>

namespace pastoso::liquid {

struct TeaFrame {
    double time_s = 0.0;
    int step = 0;
    std::vector<Parcel> parcels;
    grid::BoxField dissolved;  ///< milk that has dissolved, share of the volume, at the middles of cells
    grid::BoxField coldness;   ///< of the same shape, or empty: not kept
    SeenPour pour;
};

}  // namespace pastoso::liquid

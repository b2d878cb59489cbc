// The tea at one moment: all that is needed to go on from it, to the last bit.
#pragma once

#include "liquid/flow/flow.hpp"
#include "liquid/tea/milk_balls.hpp"
#include "liquid/tea/milk_jug.hpp"
#include "liquid/tea/parcel.hpp"

#include <vector>

namespace pastoso::liquid {

struct TeaState {
    int step = 0;
    std::vector<Parcel> parcels;
    grid::BoxField dissolved, coldness;
    FlowState flow;
    MilkBalls::State balls;
    MilkJug::State jug;
    friend bool operator==(const TeaState&, const TeaState&) = default;
};

}  // namespace pastoso::liquid

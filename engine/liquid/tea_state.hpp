// The tea at one moment: all that is needed to go on from it, to the last bit.
#pragma once

#include "liquid/flow.hpp"
#include "liquid/milk_balls.hpp"
#include "liquid/milk_jug.hpp"
#include "liquid/parcel.hpp"

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

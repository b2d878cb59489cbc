// The state of a solver besides the film itself: which tiles are awake, since when, and the pressures of
// the last step. A solver that is given it back goes on to the same bits.
#pragma once

#include "film/state.hpp"
#include "film/tile_activity.hpp"

#include <cstdint>
#include <vector>

namespace pastoso::film {

struct SolverState {
    /// A tile that is awake.
    struct AwakeTile {
        int tile = 0;
        TileActivity activity;
        grid::TileBlock<std::int32_t> window_start;  ///< none where a window has just begun
    };
    struct TilePressure {
        int tile = 0;
        grid::TileBlock<float> pressure_mm2_s2;  ///< of the last large step
    };

    std::int64_t calls = 0;                 ///< of Solver::advance(), which waits are counted in
    std::vector<AwakeTile> awake{};         ///< in ascending order
    std::vector<TilePressure> pressures{};  ///< in ascending order
    Totals runoff{};
};

}  // namespace pastoso::film

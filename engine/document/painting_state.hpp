// All that what comes next depends on: what a project file keeps, and what a painting is made of again.
#pragma once

#include "document/painting_value.hpp"
#include "film/cell/ageing.hpp"
#include "film/solver_state.hpp"

#include <cstdint>
#include <optional>

namespace pastoso::document {

/// A film and what its solver remembers of it.
struct SurfaceState {
    film::FilmState film;
    film::SolverState solver;
};

/// A painting and what its solvers remember of it. Not part of it: what Undo could return to, and
/// figures of time and work.
struct PaintingState {
    PaintingValue value{};
    film::SolverState solver{};
    film::SolverState well_solver{};  ///< of the well, where there is one
    film::AgeingClock::Pending ageing{};
    std::int64_t tick = 0;
};

/// The hash that Painting::state_hash() gives for such a painting.
std::uint64_t state_hash(const PaintingValue& value);
inline std::uint64_t state_hash(const PaintingState& state) {
    return state_hash(state.value);
}

}  // namespace pastoso::document

// A painting between two strokes as plain data: what a project file keeps, and what a painting is made
// of again.
#pragma once

#include "brush/stroke.hpp"
#include "document/events.hpp"
#include "document/layers.hpp"
#include "document/selection.hpp"
#include "film/cell/ageing.hpp"
#include "film/solver_state.hpp"
#include "film/state.hpp"
#include "layers/tracing.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::document {

/// Wet paint and the state of its solver.
struct SurfaceState {
    film::FilmState film;
    film::SolverState solver;
};

/// The brush in hand.
struct BrushState {
    TakeBrush taken;                    ///< which one it is
    std::vector<brush::Contents> held;  ///< by each of its bristles
    std::uint32_t strokes_begun = 0;
};

/// Everything that what comes next depends on. Not part of it: what Undo could return to, and figures of
/// time and work. Copies share tiles.
struct PaintingState {
    CanvasSettings settings{};
    std::int64_t tick = 0;

    SurfaceState canvas{};  ///< the active layer, on what is visible below it
    LayerStack layers = single_layer();
    /// The bare support as its name tells it to be. Tiles of the canvas's support that are shared with
    /// it are as they were made; it may be background where they are not.
    film::SupportHeights bare_support_mm{};
    std::optional<SurfaceState> well{};  ///< none: nothing has touched it

    UseMedium medium{};  ///< in hand
    TiltCanvas tilt{};
    film::DryingAir air{};
    film::AgeingClock::Pending ageing{};

    std::optional<BrushState> brush{};
    brush::HandAids aids{};
    brush::Symmetry symmetry{};
    Selection selection{};
    std::shared_ptr<const layers::Tracing> tracing{};  ///< null: none

    brush::Contents taken{};           ///< from the tubes so far
    brush::Contents wiped{};           ///< off the brush so far
    film::Totals forgotten_run_off{};  ///< over the edges, in a past that was undone
};

/// The hash that Painting::state_hash() gives for such a painting.
std::uint64_t state_hash(const PaintingState& state);

}  // namespace pastoso::document

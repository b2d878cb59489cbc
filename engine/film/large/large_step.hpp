// One implicit step of the film over a set of tiles, as long as a frame: see docs/physics.md, "Large
// steps".
#pragma once

#include "core/thread_pool.hpp"
#include "film/explicit/tile_update.hpp"
#include "film/large/large_tile.hpp"
#include "film/large/tile_window.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace pastoso::film {

/// How well the implicit equations of a step were met, and what had to be cut.
struct LargeStepReport {
    int sweeps = 0;  ///< over all tiles, the last one without correction where it found none needed
    float residual = 0.0F;           ///< largest error of thickness before the last sweep, relative
    bool draws_back = false;         ///< ends of the film would have drawn back too far
    std::int64_t limited_cells = 0;  ///< thick ones whose outflow was cut by more than a tenth
    std::int64_t clamped_faces = 0;  ///< whose flux was cut to the capacity left ahead
};

/// Steps tiles, and keeps the pressure of each from one step to the next.
class LargeStepper {
  public:
    LargeStepper(grid::Shape shape, Edge edge_x, Edge edge_y, int thread_count);

    /// Advances the tiles of `places`, which do not see the others. Returns what is new in each, in
    /// their order; or nothing, when the equations could not be met or ends of the film would draw back
    /// too far, and `accept_any` is false: a shorter step will do. `workers` holds a scratch per thread
    /// of the pool.
    std::vector<TileResult> step(const FilmState& state, const std::vector<TilePlace>& places,
                                 const StepConstants& step, core::ThreadPool& pool,
                                 std::vector<std::unique_ptr<WorkerScratch>>& workers, bool accept_any,
                                 LargeStepReport& report);

    /// After the results of a step have become the state: where paint remembers its motion, velocities
    /// become those of the new thickness, of no more kinetic energy than the step left them.
    void settle(FilmState& state, const std::vector<TilePlace>& places, core::ThreadPool& pool,
                std::vector<std::unique_ptr<WorkerScratch>>& workers) const;

    /// Forgets a tile that fell asleep.
    void forget(int tile);

    /// What a step leaves for the next one: the pressure of each tile's surface in mm2/s2, where there
    /// was one.
    using Pressures = std::vector<grid::TileBlock<float>>;
    const Pressures& pressures() const { return last_pressures_; }
    void restore(Pressures pressures) { last_pressures_ = std::move(pressures); }

  private:
    struct Windows {
        std::vector<WindowRun> next_cells;  ///< margin of one cell
        std::vector<WindowRun> patch;       ///< margin of kWindowMargin
        std::vector<WindowRun> covers;      ///< by the patches of this and other tiles
    };
    struct Pass;

    void lend_tiles(const std::vector<TilePlace>& places);

    Edge edge_x_, edge_y_;
    std::vector<Windows> columns_, rows_;
    Pressures last_pressures_;
    std::vector<LargeTile*> tiles_;  ///< of the last step; null where none took part, or sleeps since
    /// What is lent to them: as many as steps of late have needed.
    std::vector<std::unique_ptr<LargeTile>> spare_tiles_;
    double lately_needed_ = 0.0;
    std::vector<std::unique_ptr<LargeScratch>> scratch_;
};

}  // namespace pastoso::film

// A painting that is worked on: its value, what moves its paint, the stroke in progress and what Undo
// returns to. For the files of Painting and of its actions alone.
#pragma once

#include "brush/stroke_group.hpp"
#include "document/contents.hpp"
#include "document/history.hpp"
#include "document/layered_canvas.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/well.hpp"
#include "film/cell/ageing.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::document {

/// How the stroke in progress began, for TurnStroke.
struct StrokeBegun {
    std::optional<Moment> before;  ///< none: it was turned
    Surface surface = Surface::Canvas;
    std::vector<brush::PenSample> samples;
};

/// The step that a stroke becomes once it touches.
struct AwaitedStep {
    Moment before;
    UndoStep step;
};

struct LivingPainting {
    LivingPainting(const CanvasSettings& settings, film::SupportHeights support_mm,
                   core::ThreadPool& threads);
    /// The solvers' memories come last: whatever else is set wakes paint.
    LivingPainting(const PaintingState& state, core::ThreadPool& threads);
    LivingPainting(const LivingPainting&) = delete;
    LivingPainting& operator=(const LivingPainting&) = delete;

    PaintingState state() const;  ///< no stroke is in progress
    Moment moment() const;
    void return_to(const Moment& then);  ///< no stroke is in progress

    // Strokes.

    /// Guides and symmetries lie on the canvas; in the well the hand is free.
    void begin_stroke_on(Surface surface);
    void end_stroke();
    /// Tools, flow and drying keep out of what is masked from now on.
    void mask(Masking masking);
    /// What is selected and not masked, on any layer; null: all.
    const Selection& unmasked();
    /// The cells of the active layer that tools may change: where what is bare is locked, only those
    /// with paint. Null: all.
    Selection within_reach();
    /// Tells the solver and the account what the stroke did.
    void finish_contacts();
    /// The brush is another one, or holds something else, than at the moments before.
    void touch_brush();
    /// The solver of the well, which comes to be with its first use.
    film::Solver& used_well();

    // The account.

    /// What there is more of came out of the tubes, what there is less of was wiped off.
    void book(const LayerChange& paint);
    void book(const brush::Contents& before, const brush::Contents& after);
    /// What has run over the edges counts as wiped off: the solver counts in cells, which become others.
    void forget_run_off();
    brush::Contents contents_of(const LayerPaint& paint) const;
    brush::Contents held_paint() const;
    brush::Contents paint_in_well() const;
    film::Totals run_off() const {
        return difference(canvas.solver.runoff(), value.flows.forgotten_run_off);
    }

    // Time.

    /// The canvas has let a tick pass: the rest of the painting does too.
    void finish_tick(film::AdvanceReport flow);

    const Layer& active_layer() const { return value.layers.layers[value.layers.active]; }
    /// That of the value, the same one as long as it is equal.
    const std::shared_ptr<const LayerStack>& shared_layers();

    PaintingValue value;
    core::ThreadPool& pool;
    film::Medium medium;  ///< the numbers of the one in hand
    LayeredCanvas canvas;
    std::optional<film::Solver> well_solver;  ///< there is one as long as there is a well
    film::AgeingClock ageing;
    Selection stroke_limit;  ///< of the stroke in progress; null: all cells
    std::optional<brush::StrokeGroup> stroke;
    film::Solver* touched = nullptr;   ///< of the surface that the stroke is on
    std::optional<StrokeBegun> begun;  ///< as long as there is a stroke
    std::optional<AwaitedStep> awaited_step;  ///< of a stroke that has touched nothing yet
    std::int64_t late_strokes = 0;            ///< that touched after they had begun beside
    const ActionTraits* latest = nullptr;     ///< of the latest action that was carried out
    std::uint64_t brush_touches = 0;
    std::optional<ResizedCanvas> ready_canvas;       ///< Painting::have_ready()
    std::shared_ptr<const LayerStack> layers_shown;  ///< in the latest snapshot
    History history;

    std::int64_t tick = 0;
    StageTimes times;
    film::AdvanceReport film_report;

  private:
    film::Solver& make_well_solver();
    void remember_awaited_step();
    /// What lies on one surface, the brush may carry to the other.
    void share_consistencies();
    void age();

    /// What unmasked() gave last, and of what.
    struct Unmasked {
        Selection selection{};
        Masking masking{};
        Selection cells{};
    } unmasked_;
};

}  // namespace pastoso::document

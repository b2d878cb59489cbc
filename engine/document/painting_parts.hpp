// What a painting is made of, and how its actions change it. For the files of Painting alone.
#pragma once

#include "brush/brush.hpp"
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
#include <utility>
#include <vector>

namespace pastoso::document {

struct Painting::Parts {
    Parts(const CanvasSettings& wanted, film::SupportHeights support_mm, core::ThreadPool& threads);
    /// The solvers' memories come last: whatever else is set wakes paint.
    Parts(const PaintingState& state, core::ThreadPool& threads);
    PaintingState state() const;

    // Actions, which have passed check_action().

    void operator()(const TakeBrush& take);
    void operator()(const LoadPaint& load);
    void operator()(const CleanBrush& clean);
    void operator()(const UseMedium& use);
    void operator()(const TiltCanvas& wanted);
    void operator()(const SetDrying& drying);
    void operator()(const DryNow&);
    void operator()(const PenDown& pen);
    void operator()(const PenMove& pen);
    void operator()(const PenUp&);
    void operator()(const Undo&);
    void operator()(const Redo&);
    void operator()(const SqueezePaint& squeeze);
    void operator()(const CleanWell&);
    void operator()(const SelectArea& area);
    void operator()(const SelectByHeight& heights);
    void operator()(const SelectByWetness& wetness);
    void operator()(const InvertSelection&);
    void operator()(const SelectAll&);
    void operator()(const SelectLayer& select);
    void operator()(const AddLayer& add);
    void operator()(const PaintPicture& paint);
    void operator()(const LayTracing& lay);
    void operator()(const SetTracing& set);
    void operator()(const SetLayer& set);
    void operator()(const SetGroup& set);
    void operator()(const MoveLayer& move);
    void operator()(const MoveGroup& move);
    void operator()(const GroupLayers& group);
    void operator()(const UngroupLayers& ungroup);
    void operator()(const MergeDown& merge);
    void operator()(const FlattenLayers&);
    void operator()(const DuplicateLayer& duplicate);
    void operator()(const RemoveLayer& remove);
    void operator()(const ClearLayer& clear);
    void operator()(const TransformLayer& transform);
    void operator()(const ResizeCanvas& resize);
    void operator()(const SetStabiliser& set);
    void operator()(const SetGuide& set);
    void operator()(const SetSymmetry& set);

    // Strokes.

    /// Guides and symmetries lie on the canvas; in the well the hand is free.
    void begin_stroke_on(Surface surface);
    void end_stroke();
    /// Tells the solver and the account what the stroke did.
    void hand_over();
    void wipe_brush(double share = 1.0);
    bool brush_holds_paint() const { return brush && brush->contents().volume_mm3 > 0.0; }

    Well& used_well();
    /// What differs on one surface, the brush may carry to the other.
    void share_varied();
    std::optional<film::FilmState> well_film() const {
        return well ? std::optional(well->film) : std::nullopt;
    }

    // The canvas.

    /// A change that cannot be made leaves all as it was.
    template <class Change>
    void change_layers(Step step, const Change& change) {
        end_stroke();
        Moment before = moment();
        change();
        history.remember(std::move(before), std::move(step));
    }
    const std::shared_ptr<const LayerStack>& shared_layers();
    film::SupportHeights resized_support(const CanvasSettings& wanted, const grid::Extent& extent);
    void select(const grid::Mask& area, Combination how);
    void replace_selection(Selection wanted);
    void replace_tracing(layers::Tracing wanted);

    // The account.

    /// What there is more of came out of the tubes, what there is less of was wiped off.
    void book(const LayerChange& paint);
    brush::Contents contents_of(const LayerPaint& paint) const;
    brush::Contents held_paint() const;
    brush::Contents paint_in_well() const;
    film::Totals run_off() const { return difference(solver.runoff(), forgotten_run_off); }

    // Time.

    /// The canvas has let a tick pass: the rest of the painting does too.
    void finish_tick(film::AdvanceReport flow);
    void age();

    // What Undo returns to.

    Step stroke_step(Surface surface) const;
    /// Throws InputError when there is no such layer.
    Step layer_step(Step::Kind kind, LayerId layer) const;
    Step group_step(Step::Kind kind, GroupId group) const;
    const std::string& active_name() const {
        return canvas.stack().layers[canvas.stack().active].look.name;
    }
    Moment moment() const;
    /// A brush that was not touched since then gets back what it held. Any other stays in hand as it is,
    /// as if it had been filled afresh, and what was on the old one counts as wiped off.
    void return_to(const Moment& then);
    void return_well_to(const Moment& then);
    /// What rested then rests now, unless other forces act on it.
    static void restart(film::Solver& solver, const std::vector<bool>& awake, bool same_forces);

    std::shared_ptr<const BareCanvas> bare;
    core::ThreadPool& pool;
    UseMedium used_medium;  ///< which one is in hand
    film::Medium medium;    ///< the same: what the next load is mixed with
    LayeredCanvas canvas;
    std::shared_ptr<const LayerStack> layers_shown;  ///< in the latest snapshot
    film::FilmState& film = canvas.film;             ///< of the active layer
    film::Solver& solver = canvas.solver;
    std::unique_ptr<Well> well;  ///< none until something touches it
    TiltCanvas tilt;
    film::DryingAir air;
    film::AgeingClock ageing;
    std::optional<brush::Brush> brush;
    TakeBrush taken_brush;  ///< which one is in hand
    brush::HandAids aids;
    brush::Symmetry symmetry;
    Selection selection;
    std::shared_ptr<const layers::Tracing> tracing;  ///< null: none
    std::optional<brush::StrokeGroup> stroke;
    film::Solver* touched = &solver;  ///< of the surface that the stroke is on
    brush::PenSample last_sample;
    std::uint64_t brush_use = 0;  ///< grows whenever the brush is taken, loaded or cleaned

    brush::Contents taken, wiped;
    film::Totals forgotten_run_off;  ///< ran off in a past that was undone
    History history;

    std::int64_t tick = 0;
    StageTimes times;
    film::AdvanceReport film_report;
};

}  // namespace pastoso::document

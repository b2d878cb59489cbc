// The painting a user works on: support, wet film, the brush in hand, history and the account of all
// paint.
#pragma once

#include "brush/load_profile.hpp"
#include "core/thread_pool.hpp"
#include "document/canvas.hpp"
#include "document/events.hpp"
#include "document/layers.hpp"
#include "document/masking.hpp"
#include "document/selection.hpp"
#include "document/undo_step.hpp"
#include "film/solver.hpp"
#include "film/state.hpp"
#include "grid/tiled_field.hpp"
#include "layers/tracing.hpp"
#include "pigment/bands.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace pastoso::document {

/// Internal reflectance of a canvas primed with white gesso, a little yellow in the violet.
inline constexpr pigment::Bands kPrimedGround = {0.90F, 0.93F, 0.93F, 0.93F, 0.93F, 0.93F};

/// What the renderer needs, shared with the painting copy-on-write: taking one costs a few microseconds
/// and it may be read on any thread while the painting goes on.
struct Snapshot {
    film::FilmState film;
    pigment::Bands ground{};  ///< internal reflectance of the bare support, and of the bare well
    std::int64_t tick = 0;
    std::optional<film::FilmState> well{};  ///< the mixing well's; none while nothing has touched it
    brush::LoadProfile brush_load{};        ///< of the brush in hand
    std::shared_ptr<const LayerStack> layers{};  ///< the same one until something about them changes
    std::shared_ptr<const film::FilmState> active{};  ///< the active layer's; null where `film` is it
    Selection selection{};
    Masking masking{};
    std::shared_ptr<const BareCanvas> bare{};
    std::shared_ptr<const layers::Tracing> tracing{};  ///< not in `film`; null: none
    SharedReferences references{};
    std::shared_ptr<const film::FilmState> copied{};   ///< what PastePaint lays down; null: nothing
    std::uint64_t posted_actions = 0;  ///< those of a session's queue that are in it, from the first on
};

/// Where all the paint is, in mm3 of volume and in mm3 times the pigment coefficients (K_k, S_k per mm).
struct Account {
    struct Amount {
        double volume_mm3 = 0.0;
        std::array<double, pigment::kChannels> pigment{};
    };
    Amount taken;   ///< loaded from the tubes so far
    Amount canvas;  ///< wet
    Amount dried;   ///< on the canvas too
    Amount brush;   ///< in hand, and during a stroke those of its other copies
    Amount ledger;  ///< wiped off, run off the edges, or evaporated
    Amount well{};  ///< in the mixing well

    double volume_error_rel() const;   ///< |canvas + dried + brush + ledger + well - taken| / taken
    double pigment_error_rel() const;  ///< the largest of the channels, relative to that channel's taken
};

/// Seconds of wall time spent so far, per stage.
struct StageTimes {
    double brush_s = 0.0;
    double film_s = 0.0;
};

struct LivingPainting;
struct PaintingState;

/// Single-threaded to the outside: one thread owns it and calls everything but what a Snapshot holds.
class Painting {
  public:
    /// Throws InputError when the canvas would not fit into memory or the support is unknown. A support
    /// "image" is loaded by recordings::make_painting().
    Painting(const CanvasSettings& settings, core::ThreadPool& pool);

    /// The same on a support that is given, of the shape canvas_shape(settings).
    Painting(const CanvasSettings& settings, film::SupportHeights support_mm, core::ThreadPool& pool);

    /// Goes on from such a state: the same actions and ticks give the same bits as in the painting that
    /// it was taken of. Undo has nothing to return to. The shapes are those of the settings and of the
    /// well, and what the brush holds are as many contents as it has bristles.
    Painting(const PaintingState& state, core::ThreadPool& pool);
    ~Painting();

    /// Applies an event at once. Throws InputError for an unknown brush, pigment or medium, for values
    /// out of range (events.hpp), and for paint or a pen without a brush in hand; the painting is then
    /// as it was. PenMove and PenUp without a stroke, Undo and Redo with nothing to return to do
    /// nothing. Whatever touches the brush, and Undo and Redo, end a stroke in progress first.
    ///
    /// Undo brings back canvas, well and account as they were before the last stroke, DryNow,
    /// SqueezePaint or CleanWell. The brush gets
    /// back what it held then, unless it was taken, loaded or cleaned since: then it stays as it is.
    void apply(const Action& action);

    /// What the next ResizeCanvas asks for, made before: where it is of this canvas and asks for the
    /// same, it need not make it anew. Painted is the same.
    void have_ready(ResizedCanvas canvas);

    /// Lets one tick (kTick_s) of paint time pass.
    void advance_tick();

    /// The same, but `cancelled` is asked again and again; once it says true the painting is put back as
    /// it was before the tick, and false is returned.
    bool advance_tick_unless(const std::function<bool()>& cancelled);

    /// Memory that the states kept for Undo may hold beside the living one (512 MiB at first); the
    /// oldest go first. 0 switches Undo off.
    void set_history_budget(std::size_t bytes);

    /// Keeps so many steps for Undo (500 at most), whatever memory they take: those that a recording
    /// needs (undo_depth()) are the same under any budget that it was painted with.
    void keep_undo_steps(std::size_t count);

    std::int64_t tick() const;
    const CanvasSettings& settings() const;
    const film::FilmState& film() const;  ///< of the active layer, on what is visible below it
    const LayerStack& layers() const;
    const film::FilmState* well() const;  ///< the mixing well's; null while nothing has touched it
    Snapshot snapshot() const;
    PaintingState state() const;  ///< no stroke is in progress
    bool can_undo() const;
    bool can_redo() const;
    /// What Undo would take back, the oldest first, and what Redo would do again, the next one last.
    std::vector<KeptStep> undo_steps() const;
    std::vector<KeptStep> redo_steps() const;
    bool stroke_in_progress() const;
    /// How many strokes began beside canvas and well, and touched later.
    std::int64_t late_strokes() const;

    Account account() const;
    StageTimes stage_times() const;
    film::AdvanceReport film_report() const;  ///< summed over all ticks
    std::uint64_t state_hash() const;  ///< of the canvas, and of the well where there is something in it

  private:
    std::unique_ptr<LivingPainting> living_;
};

}  // namespace pastoso::document

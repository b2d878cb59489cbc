// The canvas with its layers. The paint of one of them flows; the others keep theirs as it is.
#pragma once

#include "brush/contents.hpp"
#include "core/orientation.hpp"
#include "core/thread_pool.hpp"
#include "document/actions/copy_actions.hpp"
#include "document/actions/group_actions.hpp"
#include "document/actions/layer_actions.hpp"
#include "document/actions/picture_actions.hpp"
#include "document/painting_value.hpp"
#include "film/medium.hpp"
#include "film/solver.hpp"
#include "film/state.hpp"
#include "grid/extent.hpp"
#include "grid/mask.hpp"
#include "layers/adjusting.hpp"
#include "layers/apart.hpp"
#include "layers/resampling.hpp"
#include "layers/view.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace pastoso::document {

using LayerFilms = std::vector<std::shared_ptr<const film::FilmState>>;

/// The layers from below, apart from what they lie on, `film` being the active one.
LayerFilms layers_apart(const film::FilmState& film, const film::SupportHeights& bare_mm,
                        const LayerStack& stack);

/// Layers apart, from below, as far as they show: without what is hidden of those that are clipped.
LayerFilms shown_layers(LayerFilms films, const LayerStack& stack);

/// The bare support with all that is visible below the active layer.
film::SupportHeights base_below_active(const LayerStack& stack, film::SupportHeights bare_mm);

/// All that is visible of a painting as one film (layers/view.hpp).
film::FilmState view_of(const film::FilmState& film, const film::SupportHeights& bare_mm,
                        const LayerStack& stack, core::ThreadPool& pool);

/// The same of an active layer that is apart from what it lies on, by a view that keeps what it saw.
film::FilmState seen_by(layers::View& view, const film::FilmState& active,
                        const film::SupportHeights& bare_mm, const LayerStack& stack,
                        core::ThreadPool& pool);

/// What is on a layer in all, and what has left it as vapour.
struct LayerPaint {
    film::Totals wet;
    film::DriedTotals dried;
    std::int64_t evaporated = 0;
};

/// What a layer has held before and after a change.
struct LayerChange {
    LayerPaint before, after;
};

/// What came out of the tubes for a change, and what was wiped off.
struct AdjustedPaint {
    LayerPaint taken, wiped;
};

/// Moves the paint of a painting's active layer, and changes its layers: film, stack and bare canvas of
/// the value, which outlives it. Not to be copied: the solver holds on to the film.
class LayeredCanvas {
  public:
    LayeredCanvas(PaintingValue& painting, const film::Medium& medium, core::ThreadPool& pool);

    LayeredCanvas(const LayeredCanvas&) = delete;
    LayeredCanvas& operator=(const LayeredCanvas&) = delete;

    film::Solver solver;

    /// Paint of it may come onto the active layer from now on; what lies there stays what it is.
    void set_medium(const film::Medium& medium);

    /// Returns to film, stack and bare canvas of another value. Which of its paint moves is for the
    /// caller to say (film::Solver::restart).
    void restore(const PaintingValue& then);

    /// Cuts the canvas or makes it larger; `bare` is the support of all of it. What is cut off is gone.
    LayerChange resize(const grid::Extent& extent, std::shared_ptr<const BareCanvas> bare);

    /// Turns the canvas; `bare` is its support then. Paint that rests goes on resting.
    void turn(const core::Orientation& turn, std::shared_ptr<const BareCanvas> bare);

    /// Makes the canvas of other cells; `bare` is its support then. Paint begins at rest.
    void resample(const layers::Resampling& resampling, std::shared_ptr<const BareCanvas> bare);

    // Changes of the layers (actions). They throw InputError, and leave all
    // as it was, for layers and places that there are not, and for changes of what is locked. Paint that
    // is transformed, pasted or made of a picture keeps off what is masked; layers that are merged,
    // duplicated or put in another order are so as a whole.

    void add(const AddLayer& added);
    void select(const SelectLayer& selected);
    void set(const SetLayer& set);
    void set_group(const SetGroup& set);
    void move(const MoveLayer& move);
    void group(const GroupLayers& group);
    void move_group(const MoveGroup& move);
    void ungroup(const UngroupLayers& ungroup);
    LayerPaint merge_down(const MergeDown& merge);        ///< what was hidden, and is wiped off
    LayerPaint flatten();                                 ///< the same
    LayerPaint paint_picture(const PaintPicture& paint);  ///< what came out of the tubes
    /// Puts a film that is apart from what it lies on below all layers, as one of that name. What came
    /// out of the tubes.
    LayerPaint lay_ground(const std::string& name, film::FilmState ground);
    LayerPaint pour(const film::FilmState& poured);  ///< onto the active layer; the same
    /// Adjusts what is dry on the active layer (layers::adjusted()). Throws InputError where nothing is.
    AdjustedPaint adjust_dry(const film::PaintCoefficients& paint, const layers::Adjustment& adjustment,
                             const grid::Mask* where);
    LayerPaint duplicate(const DuplicateLayer& duplicate);  ///< what came out of the tubes
    LayerPaint paste(const PastePaint& paste, const film::FilmState& copied);  ///< the same
    LayerPaint remove(const RemoveLayer& remove);                              ///< what was wiped off
    /// What was wiped off. Without a selection, null, that is everything.
    LayerPaint clear(const ClearLayer& clear, const grid::Mask* selection);
    /// `map_cells`: where what lies on the layer comes to, as far as it is selected and not masked;
    /// null: all (layers/transform.hpp).
    LayerChange transform(LayerId layer, const layers::Projective& map_cells,
                          const grid::Mask* unmasked);

    /// The paint of a layer, or all that is visible, apart from what it lies on. With a selection, what
    /// is selected of it. Throws InputError where there is none such.
    film::FilmState copy(const CopyPaint& copy, const grid::Mask* selection);

    /// The bare support with all that is visible below the active layer.
    const film::SupportHeights& base_mm() const { return base_mm_; }

    /// Sums over all layers.
    LayerPaint paint() const;

    /// All that is visible as one film (layers/view.hpp).
    film::FilmState view();

  private:
    /// Changes a stack in which every layer is inactive, and lays it out again.
    void rearrange(const std::function<void(LayerStack&)>& change);
    /// Changes every layer as `changed` says, and lays them out on another canvas.
    void lay_out_on(std::shared_ptr<const BareCanvas> bare,
                    const std::function<film::FilmState(const film::FilmState&)>& changed);
    LayerStack all_inactive();
    void expect_medium();
    film::SupportHeights base_of(const LayerStack& stack) const;

    core::ThreadPool& pool_;
    PaintingValue& painting_;
    film::SupportHeights base_mm_;  ///< the bare support with all that is visible below the active layer
    layers::Lifter lifter_;
    layers::View view_;
};

/// The hash of a film that is the stack's active layer, and of the other layers.
std::uint64_t state_hash(const film::FilmState& film, const LayerStack& stack);

}  // namespace pastoso::document

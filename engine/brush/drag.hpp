// A moving tip drags the wet paint that it touches along. Runny paint goes on flowing; stiff paint
// forgets its motion at once and is ploughed instead (brush/plough.hpp).
#pragma once

#include "brush/brush.hpp"
#include "brush/cell_batch.hpp"
#include "brush/hand_pose.hpp"
#include "brush/transfer.hpp"
#include "film/state.hpp"

#include <vector>

namespace pastoso::brush {

/// What the paint below a tip is drawn towards in one step, and how fast.
struct DragRates {
    float share = 0.0F;  ///< momentum (1 - e^(-ds / r)), the resolved footprint's share of it
    float velocity_x_mm_s = 0.0F, velocity_y_mm_s = 0.0F;  ///< of the tip
    float speed_mm_s = 0.0F;                               ///< its absolute value
    std::int32_t least_quanta = 1;  ///< thickness from which on any of the film's paint goes on moving
};
DragRates drag_rates(const Brush& brush, const ResolvedTip& tip, const HandPose& hand, double step_mm,
                     const film::Consistencies& paint);

/// Draws the depth-mean velocity u at every face between two wet cells towards the tip's:
///
///     u += s (u_tip - u),    s = momentum (1 - e^(-ds / r)) share w chi, the mean of both cells,
///
/// with the weight w, the share and the contact chi of the rule (brush/transfer.hpp). Never faster than
/// the tip or than the paint was already. A cell whose paint would stop within 2 um,
///
///     u_tip h^2 / 3 nu,
///
/// is left alone, h being the thickness of the thickest cell. `touched` are the cells as they were
/// gathered for the rule.
class PaintDrag {
  public:
    /// Finds s. Returns whether any paint is dragged along.
    bool find(const ExchangeRule& rule, const DragRates& rates, const CellBatch& touched,
              const film::FilmState& film);

    /// Draws the paint along by what was found. Returns the cells whose motion may have changed.
    grid::Rect apply(const DragRates& rates, film::FilmState& film);

  private:
    /// s of the cells of a rectangle.
    struct Shares {
        grid::Rect cells;
        std::vector<float> values;
        bool any = false;
        float& at(int x, int y) {
            return values[static_cast<std::size_t>((y - cells.y0) * cells.width() + x - cells.x0)];
        }
        /// The first call makes room for `all`.
        void set(int x, int y, float share, const grid::Rect& all);
    };
    void compute_shares(const ExchangeRule& rule, const DragRates& rates, float log_viscosity,
                        const CellBatch& touched, const film::FilmState& film);

    Shares shares_;
};

}  // namespace pastoso::brush

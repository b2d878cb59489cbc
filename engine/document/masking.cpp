#include "document/masking.hpp"

#include "grid/stripes.hpp"

#include <utility>

namespace pastoso::document {
namespace {

Selection without(const Selection& before, const grid::Mask& area) {
    if (!before) return nullptr;
    grid::Mask cells = grid::combined(*before, area, Combination::Subtract);
    if (grid::chosen_area(cells).empty()) return nullptr;
    return std::make_shared<const grid::Mask>(std::move(cells));
}

/// No cell stays none.
Selection with(const Selection& before, const grid::Mask& area) {
    if (grid::chosen_area(area).empty()) return before;
    return std::make_shared<const grid::Mask>(before ? grid::combined(*before, area, Combination::Add)
                                                     : area);
}

}  // namespace

grid::Mask area_of(const MaskStripe& stripe, const film::FilmState& film) {
    std::vector<grid::Point> line;
    for (const CanvasPoint& point : stripe.line)
        line.push_back({point.x_mm / film.cell_mm, point.y_mm / film.cell_mm});
    return grid::stripe_mask(
        film.shape, line, 0.5 * stripe.width_mm / film.cell_mm,
        stripe.straight_ends ? grid::StripeEnds::Straight : grid::StripeEnds::Round);
}

Masking laid_on(const Masking& before, const grid::Mask& area, MaskingForm form) {
    return {with(before.cells, area),
            form == MaskingForm::Tape ? with(before.tape, area) : without(before.tape, area)};
}

Masking peeled(const Masking& before, const grid::Mask& area) {
    return {without(before.cells, area), without(before.tape, area)};
}

Masking changed(const Masking& before, const std::function<Selection(const Selection&)>& change) {
    return {change(before.cells), change(before.tape)};
}

Selection without_masked(const Selection& selection, const Masking& masking) {
    if (!masking.cells) return selection;
    return std::make_shared<const grid::Mask>(
        selection ? grid::combined(*selection, *masking.cells, Combination::Subtract)
                  : grid::inverted(*masking.cells));
}

}  // namespace pastoso::document

#include "document/masking.hpp"

#include "grid/stripes.hpp"

#include <utility>

namespace pastoso::document {
namespace {

Masking masking_of(grid::Mask cells) {
    if (grid::chosen_area(cells).empty()) return {};
    return {std::make_shared<const grid::Mask>(std::move(cells))};
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

Masking laid_on(const Masking& before, const grid::Mask& area) {
    return masking_of(before.cells ? grid::combined(*before.cells, area, Combination::Add) : area);
}

Masking peeled(const Masking& before, const grid::Mask& area) {
    if (!before.cells) return {};
    return masking_of(grid::combined(*before.cells, area, Combination::Subtract));
}

Selection without_masked(const Selection& selection, const Masking& masking) {
    if (!masking.cells) return selection;
    return std::make_shared<const grid::Mask>(
        selection ? grid::combined(*selection, *masking.cells, Combination::Subtract)
                  : grid::inverted(*masking.cells));
}

}  // namespace pastoso::document

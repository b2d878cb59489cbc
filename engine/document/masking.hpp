// What lies under masking fluid and tape: neither tools nor flow nor drying reach its paint.
#pragma once

#include "document/actions/masking_actions.hpp"
#include "document/selection.hpp"

#include <functional>

namespace pastoso::document {

struct Masking {
    // Without soft edges.
    Selection cells{};  ///< null: nothing is masked
    Selection tape{};   ///< those of them that are under tape, the others being under fluid; null: none
    friend bool operator==(const Masking&, const Masking&) = default;
};

/// What the stripe goes over.
grid::Mask area_of(const MaskStripe& stripe, const film::FilmState& film);

/// Masks the cells of an area besides, or peels them. What was laid last is seen.
Masking laid_on(const Masking& before, const grid::Mask& area, MaskingForm form);
Masking peeled(const Masking& before, const grid::Mask& area);

/// As the canvas is cut, turned or drawn out, and `change` does it to a choice of cells.
Masking changed(const Masking& before, const std::function<Selection(const Selection&)>& change);

/// What is selected and not masked; null: all. Where all is masked, no cell.
Selection without_masked(const Selection& selection, const Masking& masking);

}  // namespace pastoso::document

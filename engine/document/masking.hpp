// What lies under masking fluid and tape: neither tools nor flow nor drying reach its paint.
#pragma once

#include "document/actions/masking_actions.hpp"
#include "document/selection.hpp"

#include <memory>

namespace pastoso::document {

struct Masking {
    std::shared_ptr<const grid::Mask> cells{};  ///< without soft edges; null: nothing is masked
    friend bool operator==(const Masking&, const Masking&) = default;
};

/// What the stripe goes over.
grid::Mask area_of(const MaskStripe& stripe, const film::FilmState& film);

/// Masks the cells of an area besides, or peels them.
Masking laid_on(const Masking& before, const grid::Mask& area);
Masking peeled(const Masking& before, const grid::Mask& area);

/// What is selected and not masked; null: all. Where all is masked, no cell.
Selection without_masked(const Selection& selection, const Masking& masking);

}  // namespace pastoso::document

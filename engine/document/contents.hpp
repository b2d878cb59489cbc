// Sums of paint on the canvas, in the units of the brush and of the account.
#pragma once

#include "brush/contents.hpp"
#include "document/painting.hpp"
#include "film/state.hpp"

namespace pastoso::document {

/// Wet paint.
brush::Contents contents_of(const film::Totals& totals, double cell_mm);

/// Dry paint; it has no viscosity any more.
brush::Contents contents_of(const film::DriedTotals& totals, double cell_mm);

/// a - b.
film::Totals difference(film::Totals a, const film::Totals& b);

Account::Amount amount(const brush::Contents& contents);

}  // namespace pastoso::document

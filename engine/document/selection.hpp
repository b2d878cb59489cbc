// The cells that tools may change.
#pragma once

#include "core/orientation.hpp"
#include "document/actions/margin_actions.hpp"
#include "document/actions/selection_actions.hpp"
#include "film/state.hpp"
#include "grid/extent.hpp"
#include "layers/resampling.hpp"
#include "layers/transform.hpp"

#include <memory>

namespace pastoso::document {

/// By which share tools may change each cell; null: none is selected, all may be changed.
using Selection = std::shared_ptr<const grid::Mask>;

/// What the lines and the ranges of selection_actions.hpp hold of a film on a bare support.
grid::Mask area_of(const SelectArea& select, const film::FilmState& film);
grid::Mask area_of(const SelectByHeight& select, const film::FilmState& film,
                   const film::SupportHeights& bare_mm);
grid::Mask area_of(const SelectByWetness& select, const film::FilmState& film);
/// The layer lies on `base_mm`.
grid::Mask area_of(const SelectPaint& select, const film::FilmState& film,
                   const film::SupportHeights& base_mm);

Selection combined(const Selection& before, const grid::Mask& region, Combination how);
Selection inverted(const Selection& before);
Selection changed_by(const GrowSelection& grow, const Selection& before, double cell_mm);
Selection changed_by(const ShrinkSelection& shrink, const Selection& before, double cell_mm);
Selection changed_by(const BorderSelection& border, const Selection& before, double cell_mm);
Selection changed_by(const FeatherSelection& feather, const Selection& before, double cell_mm);
/// Nothing that is added is selected.
Selection on_extent(const Selection& before, const grid::Extent& extent);
Selection turned(const Selection& before, const core::Orientation& turn, core::ThreadPool& pool);
/// That of a canvas that is scaled.
Selection resampled(const Selection& before, const layers::Resampling& resampling);

Selection transformed(const Selection& before, const layers::Projective& map_cells);

}  // namespace pastoso::document

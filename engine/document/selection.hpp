// The cells that tools may change.
#pragma once

#include "core/orientation.hpp"
#include "document/actions/selection_actions.hpp"
#include "film/state.hpp"
#include "grid/extent.hpp"
#include "layers/transform.hpp"

#include <memory>

namespace pastoso::document {

using Selection = std::shared_ptr<const grid::Mask>;  ///< null: none is selected, all may be changed

/// What the lines and the ranges of selection_actions.hpp hold of a film on a bare support.
grid::Mask area_of(const SelectArea& select, const film::FilmState& film);
grid::Mask area_of(const SelectByHeight& select, const film::FilmState& film,
                   const film::SupportHeights& bare_mm);
grid::Mask area_of(const SelectByWetness& select, const film::FilmState& film);

Selection combined(const Selection& before, const grid::Mask& region, Combination how);
Selection inverted(const Selection& before);
/// Nothing that is added is selected.
Selection on_extent(const Selection& before, const grid::Extent& extent);
Selection turned(const Selection& before, const core::Orientation& turn, core::ThreadPool& pool);
Selection transformed(const Selection& before, double cell_mm, const layers::Transform& transform);

}  // namespace pastoso::document

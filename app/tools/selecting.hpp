// What a painter sees and asks before something is selected: how high and how wet the paint stands, and
// what a choice would come to.
#pragma once

#include "document/painting.hpp"
#include "tools/hand.hpp"

namespace pastoso::tools {

/// Of the cells that hold any paint; zeros where none does.
struct PaintDepths {
    double mean_mm = 0.0, most_mm = 0.0;
};
PaintDepths heights_on(const document::Snapshot& painting);  ///< as SelectByHeight has them
PaintDepths wetness_on(const document::Snapshot& painting);  ///< as SelectByWetness has them

/// What would be selected afterwards.
document::Selection selection_after(const document::Snapshot& painting,
                                    const document::SelectByHeight& select);
document::Selection selection_after(const document::Snapshot& painting,
                                    const document::SelectByWetness& select);

/// The smallest rectangle around what is outlined of a selection, the cells that are selected by half or
/// more; empty where none is, as in one that is feathered widely. The selection is not null.
grid::Rect outlined_area(const document::Selection& selection);

/// Whether two selections of one canvas hold the same share of every cell. Neither is null.
bool are_same(const document::Selection& a, const document::Selection& b);

/// The share of the canvas that tools may change.
double selected_share(const document::Selection& selection);

/// Whether the hand, or one of its copies, touches a selected cell when it comes down there with a tip
/// that reaches so far.
bool touches_selection(const document::Snapshot& painting, const brush::Symmetry& symmetry, double x_mm,
                       double y_mm, double reach_mm);

}  // namespace pastoso::tools

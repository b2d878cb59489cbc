// How a painter chooses what tools may change, as plain data.
#pragma once

#include "grid/mask.hpp"

#include <vector>

namespace pastoso::document {

/// Where no cell is selected, everything is: tools may change the whole canvas. Then Add and Intersect
/// are Replace, Subtract leaves all but the region. A selection of no cell at all is none.
using grid::Combination;

struct CanvasPoint {
    double x_mm = 0.0, y_mm = 0.0;
    friend bool operator==(const CanvasPoint&, const CanvasPoint&) = default;
};

inline constexpr std::size_t kMostOutlinePoints = 20000;

struct SelectArea {  ///< what a closed line goes around: a rectangle's corners or a lasso
    std::vector<CanvasPoint> outline{};  ///< 3 to kMostOutlinePoints
    Combination how = Combination::Replace;
    friend bool operator==(const SelectArea&, const SelectArea&) = default;
};
/// Where the paint that the active layer holds and what is visible below it are so high together, wet
/// and dry, from the bare support on.
struct SelectByHeight {
    double least_mm = 0.0, most_mm = 0.0;  ///< both included, 0 to 1000
    Combination how = Combination::Replace;
    friend bool operator==(const SelectByHeight&, const SelectByHeight&) = default;
};
struct SelectByWetness {                   ///< where the wet paint of the active layer is so thick
    double least_mm = 0.0, most_mm = 0.0;  ///< both included, 0 to 1000
    Combination how = Combination::Replace;
    friend bool operator==(const SelectByWetness&, const SelectByWetness&) = default;
};
struct InvertSelection {
    friend bool operator==(const InvertSelection&, const InvertSelection&) = default;
};
struct SelectAll {  ///< ends the selection
    friend bool operator==(const SelectAll&, const SelectAll&) = default;
};

}  // namespace pastoso::document

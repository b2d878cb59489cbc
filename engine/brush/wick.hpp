// Paint creeps between neighbouring bristles.
#pragma once

#include "brush/brush.hpp"

namespace pastoso::brush {

/// Lets neighbours exchange paint for `length_mm` of travel: half the smaller load both ways, which
/// mixes their colours, and a quarter of the difference in fill one way, both times wick per mm. What
/// one gives the other gets.
void wick_paint(Brush& brush, double length_mm);

}  // namespace pastoso::brush

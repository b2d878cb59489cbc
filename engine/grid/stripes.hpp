// Stripes along lines, as choices of cells.
#pragma once

#include "grid/mask.hpp"

namespace pastoso::grid {

/// How a stripe ends: with half a disc around the last point, or straight across it.
enum class StripeEnds { Round, Straight };

/// The cells whose centres lie at most `radius` cells beside the line from point to point; joints and a
/// single point are round unless the ends are straight. Coordinates and `radius` are finite, that not
/// negative.
Mask stripe_mask(Shape shape, const std::vector<Point>& line, double radius, StripeEnds ends);

}  // namespace pastoso::grid

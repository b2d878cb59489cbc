// A canvas that is turned by any angle with all that lies on it.
#pragma once

#include "layers/projective.hpp"
#include "layers/tracing.hpp"
#include "layers/transform.hpp"

namespace pastoso::layers {

struct Rotation {
    double angle_deg = 0.0;  ///< clockwise, as the canvas is seen
    Place from, to;          ///< where a place of the old canvas lies on the new one
};

Projective in_cells(const Rotation& rotation, double cell_mm);

/// The picture and its place. The picture is made anew, upright, around the turned one, which lies in it
/// on transparent ground: of pixels as small as the smaller side of those it had, or larger ones where
/// these would be too many for a picture.
Tracing rotated(const Tracing& tracing, const Rotation& rotation);

}  // namespace pastoso::layers

// What the paint lies on: woven or smooth supports, or a height image, as c(x, y) in millimetres.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "grid/tiled_field.hpp"

namespace pastoso::film {

struct Weave {
    double thread_pitch_mm = 0.85;  ///< distance of neighbouring threads
    double relief_mm = 0.11;        ///< from the holes to the crowns
    double irregularity = 1.0;      ///< of thread width and course, 0 (machine-made) to 2
};

/// Heights of a weave, 0 at the holes; a function of millimetres alone, so that any resolution shows the
/// same cloth.
grid::TiledField<float> woven_support(grid::Shape shape, double cell_mm, const Weave& weave);

/// A smooth panel with a brushed-gesso tooth of `relief_mm`.
grid::TiledField<float> panel_support(grid::Shape shape, double cell_mm, double relief_mm);

/// A grey image stretched over the canvas: 0 is height 0, 1 is `relief_mm`. `grey` has width * height values
/// in [0, 1]. Resampled smoothly (cubic B-spline).
grid::TiledField<float> image_support(grid::Shape shape, const std::vector<float>& grey, int width, int height,
                                      double relief_mm);

/// "linen", "cotton duck" or "panel" with the relief given, or its own when `relief_mm` is 0. Throws
/// InputError that lists the names there are.
grid::TiledField<float> named_support(std::string_view name, grid::Shape shape, double cell_mm,
                                      double relief_mm = 0.0);

}  // namespace pastoso::film

// What a brush holds, seen across its width: for a picture of the load beside the canvas.
#pragma once

#include "film/cell/paint_cell.hpp"

#include <array>

namespace pastoso::brush {

struct Brush;

/// The tip cut into stripes along the stroke, from the left side of its width to the right.
struct LoadProfile {
    static constexpr int kStripes = 24;

    struct Stripe {
        double fill = 0.0;                ///< paint against that of a full dip
        film::PaintCoefficients paint{};  ///< of the mean paint in it, per mm; zeros where it is empty
        friend bool operator==(const Stripe&, const Stripe&) = default;
    };

    std::array<Stripe, kStripes> stripes{};
    double fill = 0.0;  ///< of the whole tip
    friend bool operator==(const LoadProfile&, const LoadProfile&) = default;
};

LoadProfile load_profile(const Brush& brush);

}  // namespace pastoso::brush

// Paint as an amount: its volume and what it carries.
#pragma once

#include "film/cell/paint_cell.hpp"

#include <array>

namespace pastoso::brush {

/// An amount of paint. What it carries is counted as volume times coefficient (for pigment mm3 K_k and
/// mm3 S_k, both in 1/mm; paint_cell.hpp lists the others), which adds up when paints are mixed and
/// never depends on where the paint is.
struct Contents {
    double volume_mm3 = 0.0;
    std::array<double, film::kPaintChannels> paint{};

    Contents& operator+=(const Contents& other) {
        volume_mm3 += other.volume_mm3;
        for (int k = 0; k < film::kPaintChannels; ++k)
            paint[k] += other.paint[k];
        return *this;
    }
    Contents& operator-=(const Contents& other) {
        volume_mm3 -= other.volume_mm3;
        for (int k = 0; k < film::kPaintChannels; ++k)
            paint[k] -= other.paint[k];
        return *this;
    }
    friend bool operator==(const Contents&, const Contents&) = default;
};

}  // namespace pastoso::brush

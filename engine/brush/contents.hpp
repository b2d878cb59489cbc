// Paint as an amount: its volume and the pigment in it.
#pragma once

#include "pigment/bands.hpp"

#include <array>

namespace pastoso::brush {

/// An amount of paint. Pigment is counted as volume times coefficient (mm3 K_k, mm3 S_k, both in 1/mm),
/// which adds up when paints are mixed and never depends on where the paint is.
struct Contents {
    double volume_mm3 = 0.0;
    std::array<double, pigment::kChannels> pigment{};

    Contents& operator+=(const Contents& other) {
        volume_mm3 += other.volume_mm3;
        for (int k = 0; k < pigment::kChannels; ++k)
            pigment[k] += other.pigment[k];
        return *this;
    }
    Contents& operator-=(const Contents& other) {
        volume_mm3 -= other.volume_mm3;
        for (int k = 0; k < pigment::kChannels; ++k)
            pigment[k] -= other.pigment[k];
        return *this;
    }
    friend bool operator==(const Contents&, const Contents&) = default;
};

}  // namespace pastoso::brush

// Smooth value noise: random numbers at whole places, joined by cubic steps. Pure functions, values in
// [0, 1).
#pragma once

#include "core/random.hpp"

#include <cmath>
#include <cstdint>

namespace pastoso::film {

inline float smooth_step(float t) {
    return t * t * (3.0F - 2.0F * t);
}

/// Between which two whole places a place lies, and where.
struct NoisePlace {
    std::uint32_t before;  ///< wraps below 0
    float share;           ///< 0 there, 1 at the next one, a smooth step
};

inline NoisePlace noise_place(double t) {
    const double whole = std::floor(t);
    return {static_cast<std::uint32_t>(static_cast<std::int32_t>(whole)),
            smooth_step(static_cast<float>(t - whole))};
}

/// Noise along a line; different streams are unrelated.
inline float smooth_noise(double t, std::uint32_t stream) {
    const NoisePlace place = noise_place(t);
    const float before = core::uniform_noise(place.before, stream);
    return before + place.share * (core::uniform_noise(place.before + 1, stream) - before);
}

/// Noise in the plane.
inline float smooth_noise(double x, double y, std::uint32_t stream) {
    const NoisePlace row = noise_place(y);
    const std::uint32_t above_row = core::scramble(stream) + row.before;
    const float above = smooth_noise(x, above_row);
    return above + row.share * (smooth_noise(x, above_row + 1) - above);
}

}  // namespace pastoso::film

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

/// Noise along a line; different streams are unrelated.
inline float smooth_noise(double t, std::uint32_t stream) {
    const double whole = std::floor(t);
    const auto index = static_cast<std::uint32_t>(static_cast<std::int32_t>(whole));
    const float share = smooth_step(static_cast<float>(t - whole));
    const float before = core::uniform_noise(index, stream);
    return before + share * (core::uniform_noise(index + 1, stream) - before);
}

/// Noise in the plane.
inline float smooth_noise(double x, double y, std::uint32_t stream) {
    const double whole = std::floor(y);
    const auto row = static_cast<std::uint32_t>(static_cast<std::int32_t>(whole));
    const float share = smooth_step(static_cast<float>(y - whole));
    const std::uint32_t plane = core::scramble(stream);
    const float above = smooth_noise(x, plane + row);
    return above + share * (smooth_noise(x, plane + row + 1) - above);
}

}  // namespace pastoso::film

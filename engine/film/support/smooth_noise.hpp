// Smooth value noise: random numbers at whole places, joined by cubic steps. Pure functions, values in
// [0, 1).
#pragma once

#include "core/random.hpp"

#include <array>
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

/// smooth_noise(x, y, stream), to the bit, at places that follow each other closely: most of the work is
/// to find the four numbers around a place, which are the same for all of them.
class NoiseWalk {
  public:
    explicit NoiseWalk(std::uint32_t stream) : plane_(core::scramble(stream)) { find(0, 0); }

    float at(double x, double y) {
        const double left = std::floor(x), top = std::floor(y);
        const auto column = static_cast<std::int32_t>(left), row = static_cast<std::int32_t>(top);
        if (column != column_ || row != row_) find(column, row);
        const float across = smooth_step(static_cast<float>(x - left));
        const float down = smooth_step(static_cast<float>(y - top));
        const float above = corners_[0] + across * (corners_[1] - corners_[0]);
        const float below = corners_[2] + across * (corners_[3] - corners_[2]);
        return above + down * (below - above);
    }

  private:
    void find(std::int32_t column, std::int32_t row) {
        column_ = column;
        row_ = row;
        const auto index = static_cast<std::uint32_t>(column);
        const std::uint32_t stream = plane_ + static_cast<std::uint32_t>(row);
        corners_ = {core::uniform_noise(index, stream), core::uniform_noise(index + 1, stream),
                    core::uniform_noise(index, stream + 1), core::uniform_noise(index + 1, stream + 1)};
    }

    std::uint32_t plane_;
    std::int32_t column_ = 0, row_ = 0;
    std::array<float, 4> corners_{};  ///< left and right above, left and right below
};

}  // namespace pastoso::film

// Smooth value noise: random numbers at whole places, joined by cubic steps. Pure functions, values in
// [0, 1).
#pragma once

#include "core/random.hpp"

#include <cmath>
#include <cstdint>
#include <span>

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

/// Between which four whole places a place lies, and where.
struct NoisePlace {
    std::int32_t column, row;
    float across, down;  ///< smooth steps
};

inline NoisePlace noise_place(double x, double y) {
    // Rounded down without a call, so that loops over it are vectorised.
    const auto below = [](double t) {
        const auto whole = static_cast<std::int32_t>(t);
        return whole - (static_cast<double>(whole) > t ? 1 : 0);
    };
    const std::int32_t column = below(x), row = below(y);
    return {column, row, smooth_step(static_cast<float>(x - column)),
            smooth_step(static_cast<float>(y - row))};
}

/// smooth_noise(x, y, stream), to the bit, at places along a line: most of the work is to find the four
/// numbers around a place, which are the same for those that follow each other closely.
class NoiseLine {
  public:
    explicit NoiseLine(std::uint32_t stream) : plane_(core::scramble(stream)) {}

    void put(std::span<const NoisePlace> places, std::span<float> values) const {
        for (std::size_t k = 0; k < places.size();) {
            const std::int32_t column = places[k].column, row = places[k].row;
            const auto index = static_cast<std::uint32_t>(column);
            const std::uint32_t stream = plane_ + static_cast<std::uint32_t>(row);
            const float left = core::uniform_noise(index, stream),
                        to_right = core::uniform_noise(index + 1, stream) - left,
                        left_below = core::uniform_noise(index, stream + 1),
                        to_right_below = core::uniform_noise(index + 1, stream + 1) - left_below;
            for (; k < places.size() && places[k].column == column && places[k].row == row; ++k) {
                const float above = left + places[k].across * to_right;
                const float below = left_below + places[k].across * to_right_below;
                values[k] = above + places[k].down * (below - above);
            }
        }
    }

  private:
    std::uint32_t plane_;
};

}  // namespace pastoso::film

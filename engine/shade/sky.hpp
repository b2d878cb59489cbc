// How much of the even sky each place sees: hollows and the feet of ridges are darker.
#pragma once

#include "film/state.hpp"

#include <array>
#include <cstddef>

namespace pastoso::shade {

inline constexpr int kHorizonDistances = 4;

/// Where the horizon is looked for in one direction: places relative to a cell's own in an array of
/// heights.
struct HorizonLook {
    std::array<std::ptrdiff_t, kHorizonDistances> offset{};
    std::array<float, kHorizonDistances> inverse_distance_per_mm{};
};

/// The share of an even sky's light that reaches each cell of a rectangle, 0 to 1. With the horizon's
/// angle b in eight directions it is the mean of cos^2 b (exact for that horizon), which on a plane
/// tilted by a is (1 + cos a) / 2. The horizon is taken from the cell means at four distances up to 2
/// mm, so that only the relief nearby darkens. `stride` floats from row to row.
void sky_shares(const film::FilmState& film, const grid::Rect& cells, float* out, int stride);

/// How far from a cell its surroundings enter.
int sky_reach_cells(double cell_mm);

}  // namespace pastoso::shade

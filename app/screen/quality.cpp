#include "screen/quality.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::screen {
namespace {

constexpr double kSampleSpacing_cells = 0.5, kFairSpacing_cells = 1.0;

/// In a picture made smaller than a third, more samples would no longer be seen.
constexpr int kMostSamples = 6;

}  // namespace

int samples_per_side(Quality quality, double px_per_cell) {
    if (quality < Quality::Fair) return 1;
    const double spacing_cells = quality == Quality::Full ? kSampleSpacing_cells : kFairSpacing_cells;
    const double wanted = std::ceil(1.0 / (px_per_cell * spacing_cells) - 1e-9);
    return static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(kMostSamples)));
}

bool coarse_is_useful(double px_per_cell) {
    constexpr double kLargeCell_px = 2.0;
    return px_per_cell >= kLargeCell_px;
}

double samples_per_pixel(Quality quality, double px_per_cell) {
    if (quality == Quality::Coarse) return 0.25;
    const double side = samples_per_side(quality, px_per_cell);
    return side * side;
}

}  // namespace pastoso::screen

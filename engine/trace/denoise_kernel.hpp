// One pass of weighted means, as the denoiser's inner loop sees it.
#pragma once

#include "core/kernels.hpp"
#include "trace/denoise.hpp"

#include <array>
#include <cstddef>

namespace pastoso::trace {

inline constexpr int kReach = 7;       ///< pixels on each side that a mean is taken over
inline constexpr int kPatchReach = 2;  ///< and that are compared
/// Around the planes lie so many copies of the pixels at their edges.
inline constexpr int kMargin = 16;
inline constexpr int kColours = 3;
inline constexpr int kAveraged = kColours + kFeatures;
/// Rows that are done in one go.
inline constexpr int kBandRows = 16;

/// Planes of floats, `stride` from row to row, each pointer at the upper left pixel. The noise is the
/// variance of a pixel's mean.
struct AverageJob {
    int width, height;
    std::ptrdiff_t stride;
    int first_row, last_row;
    std::array<const float*, kColours> guide;
    const float* guide_noise;
    std::array<const float*, kFeatures> features;
    std::array<const float*, kFeatures> feature_noise;
    int feature_count;
    float colour_scale, feature_scale;  ///< of the distances: larger means stricter
    float guide_floor;  ///< variance of a guide colour that does not count as a difference
    std::array<const float*, kAveraged> in;
    std::array<float*, kAveraged> out;
    int averaged;
};

/// Floats that average_rows() needs for a picture of this width.
constexpr std::size_t average_scratch(int width) {
    const auto row = static_cast<std::size_t>(width + 2 * kMargin);
    return row * (kBandRows + 2 * kPatchReach + 2 + kBandRows * (kAveraged + 1));
}

struct DenoiseKernels {
    /// scratch: average_scratch(job.width) floats; at most kBandRows rows.
    void (*average_rows)(const AverageJob& job, float* scratch);

    static const DenoiseKernels baseline, avx2, avx512;
};

}  // namespace pastoso::trace

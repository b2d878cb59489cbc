// The relief of brushed gesso along a line, for every instruction set.
#pragma once

#include "core/kernels.hpp"
#include "core/random.hpp"

#include <cstdint>

namespace pastoso::film {

/// What a coat of gesso is made of: noises (smooth_noise.hpp), long along the brush marks and narrow
/// across them.
struct GessoNoise {
    double along_mm, across_mm;
    std::uint32_t stream;
    std::uint32_t plane = core::scramble(stream);  ///< of its row 0
};
constexpr GessoNoise kGessoDrift{40.0, 60.0, 1};  ///< how far marks run aside
constexpr GessoNoise kBroadMarks{30.0, 1.2, 2}, kFineMarks{9.0, 0.3, 3};
constexpr GessoNoise kGessoGrain{0.6, 0.4, 4};
constexpr double kGessoDrift_mm = 3.0;  ///< at most

/// Between which two whole places of a noise columns lie, and where: as a smooth step.
struct NoiseColumns {
    const std::uint32_t* before = nullptr;
    const float* share = nullptr;
};

/// A line through a coat of gesso. What does not change along the line is a single number, all else has
/// one for each column; arrays reach as far beyond `count` as the widest registers do.
struct GessoLine {
    int count = 0;
    /// Along the marks.
    NoiseColumns drift_along{}, broad_along{}, fine_along{}, grain_along{};
    /// Across them: of those that do not drift.
    NoiseColumns drift_across{}, grain_across{};
    const double* across_mm = nullptr;
};

struct GessoKernels {
    /// Heights from 0 to 1 of `line.count` columns, and of what a register holds beyond them, along the
    /// marks.
    void (*along_marks)(const GessoLine& line, float* heights);
    /// The same across them.
    void (*across_marks)(const GessoLine& line, float* heights);
    static const GessoKernels baseline, avx2, avx512;
};

}  // namespace pastoso::film

// The height of a cloth along a line, for every instruction set.
#pragma once

#include "core/kernels.hpp"

namespace pastoso::film {

/// Sections of threads, column by column.
struct SectionColumns {
    const float* centre = nullptr;
    const float* half_width = nullptr;
    const float* crown = nullptr;
};

/// The weft threads that may lie beside a line; it lies between the second and the third of them, give
/// or take one.
constexpr int kWeftsNear = 5;

/// A line across the warp, in columns; lengths in pitches. All arrays reach as far beyond `count` as the
/// widest registers do.
struct ClothLine {
    int count = 0;
    const float* u = nullptr;  ///< of each column
    float v = 0.0F;            ///< of the line, in pitches of the weft
    SectionColumns warp_before{}, warp_after{};
    const float* warp_parity = nullptr;  ///< 1 where the warp thread before has an even number, else -1
    SectionColumns weft[kWeftsNear]{};
    float weft_parity = 1.0F;  ///< of weft[0]
    float twist = 0.0F;
    float nap = 0.0F;                                              ///< 0: no fibres
    const float *fibres_above = nullptr, *fibres_below = nullptr;  ///< noise on both sides of the line
    float fibres_share = 0.0F;                                     ///< where between them it lies
    float shown = 1.0F;  ///< of the relief; the rest is its mean
};

struct WeaveKernels {
    /// Heights from 0 to 1, of `line.count` columns and of what a register holds beyond them.
    void (*cloth_heights)(const ClothLine& line, float* heights);
    static const WeaveKernels baseline, avx2, avx512;
};

}  // namespace pastoso::film

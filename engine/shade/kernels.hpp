// The hot loops, compiled once per instruction set and chosen at run time (core/isa.hpp).
#pragma once

#include "core/kernels.hpp"
#include "film/state.hpp"
#include "shade/sampling.hpp"
#include "shade/shading_model.hpp"
#include "shade/sky.hpp"
#include "shade/tile_colour.hpp"

#include <cstdint>

namespace pastoso::shade {

/// Neighbouring cells from the wet paint down; the lower wet stratum, and what lies dry, may be null
/// where there is none.
struct CellStack {
    const film::PaintCell* paint;
    const film::PaintCell* lower;  ///< the part of it that lies below the rest
    const std::int32_t* thickness;
    const film::PigmentCell* soluble;
    const film::StrataOptics* strata;
};

/// How an outline is sampled.
struct OutlineSampling {
    float cell_mm;
    float width_cells;  ///< of a sample
    float strength;     ///< outline_strength()
};

struct Kernels {
    /// The colours of `count` cells.
    void (*colour_cells)(const CellStack& cells, int count, const pigment::Bands& bare_ground,
                         const pigment::BandsToRgb& to_rgb, CellColour* out);

    /// Adds to each of `count` cells an eighth of cos^2 of the horizon's angle in one direction
    /// (sky.hpp).
    void (*add_horizon)(const HorizonLook& look, const float* height, int count, float* out);

    /// Raises shadow heights to that of the relief one step towards the light: between the heights
    /// `near` and `far`, less what the ray drops (shadow.hpp).
    void (*raise_shadow)(const float* near, const float* far, float far_share, float drop_mm, int count,
                         float* out);

    /// Shades one row of samples; three floats a sample.
    void (*shade_row)(const LayerRows& rows, const AxisWeights& row_weights,
                      const SampleColumns& columns, float cell_mm, const ShadingConstants& light,
                      float* rgb);

    /// What lies at one row of samples.
    void (*sample_row)(const LayerRows& rows, const AxisWeights& row_weights,
                       const SampleColumns& columns, float cell_mm, SurfaceSample* out);

    /// The same of a picture that is enlarged, with outlines.
    void (*outline_row)(const LayerRows& rows, const OutlineRows& outline,
                        const AxisWeights& row_weights, const SampleColumns& columns,
                        const OutlineSampling& sampling, const ShadingConstants& light, float* rgb);
    void (*outline_samples)(const LayerRows& rows, const OutlineRows& outline,
                            const AxisWeights& row_weights, const SampleColumns& columns,
                            const OutlineSampling& sampling, SurfaceSample* out);

    static const Kernels baseline, avx2, avx512;
};

}  // namespace pastoso::shade

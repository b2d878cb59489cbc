// Compiled once per instruction set; see pastoso_add_kernels.
#include "shade/kernels.hpp"

namespace pastoso::shade::PASTOSO_ISA {

void colour_cells(const CellStack& cells, int count, const pigment::Bands& bare_ground,
                  const pigment::BandsToRgb& to_rgb, CellColour* out);
void add_horizon(const HorizonLook& look, const float* height, int count, float* out);
void raise_shadow(const float* near, const float* far, float far_share, float drop_mm, int count,
                  float* out);
void shade_row(const LayerRows& rows, const AxisWeights& row_weights, const SampleColumns& columns,
               float cell_mm, const ShadingConstants& light, float* rgb);
void sample_row(const LayerRows& rows, const AxisWeights& row_weights, const SampleColumns& columns,
                float cell_mm, SurfaceSample* out);
void outline_row(const LayerRows& rows, const OutlineRows& outline, const AxisWeights& row_weights,
                 const SampleColumns& columns, const OutlineSampling& sampling,
                 const ShadingConstants& light, float* rgb);
void outline_samples(const LayerRows& rows, const OutlineRows& outline, const AxisWeights& row_weights,
                     const SampleColumns& columns, const OutlineSampling& sampling, SurfaceSample* out);

}  // namespace pastoso::shade::PASTOSO_ISA

PASTOSO_REGISTER_KERNELS(pastoso::shade, Kernels, colour_cells, add_horizon, raise_shadow, shade_row,
                         sample_row, outline_row, outline_samples)

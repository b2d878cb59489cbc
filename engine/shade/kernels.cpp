#include "shade/kernels.hpp"

#define PASTOSO_DECLARE_SHADE_KERNELS(isa)                                                              \
    namespace isa {                                                                                     \
    void colour_cells(const CellStack& cells, int count, const pigment::Bands& bare_ground,             \
                      const pigment::BandsToRgb& to_rgb, CellColour* out);                              \
    void add_horizon(const HorizonLook& look, const float* height, int count, float* out);              \
    void raise_shadow(const float* near, const float* far, float far_share, float drop_mm, int count,   \
                      float* out);                                                                      \
    void shade_row(const LayerRows& rows, const AxisWeights& row_weights, const SampleColumns& columns, \
                   float cell_mm, const ShadingConstants& light, float* rgb);                           \
    void sample_row(const LayerRows& rows, const AxisWeights& row_weights,                              \
                    const SampleColumns& columns, float cell_mm, SurfaceSample* out);                   \
    inline constexpr Kernels kKernels = {colour_cells, add_horizon, raise_shadow, shade_row,            \
                                         sample_row};                                                   \
    }

namespace pastoso::shade {

PASTOSO_DECLARE_SHADE_KERNELS(baseline)
#ifdef PASTOSO_MULTIPLE_ISAS
PASTOSO_DECLARE_SHADE_KERNELS(avx2)
PASTOSO_DECLARE_SHADE_KERNELS(avx512)
#endif

const Kernels& kernels([[maybe_unused]] core::Isa isa) {
#ifdef PASTOSO_MULTIPLE_ISAS
    if (isa == core::Isa::Avx512) return avx512::kKernels;
    if (isa == core::Isa::Avx2) return avx2::kKernels;
#endif
    return baseline::kKernels;
}

}  // namespace pastoso::shade

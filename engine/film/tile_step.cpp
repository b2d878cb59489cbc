#include "film/tile_step.hpp"

namespace pastoso::film {

#define PASTOSO_DECLARE_KERNELS(isa)                                                                    \
    namespace isa {                                                                                     \
    FlowExtremes tile_flow(const StepConstants& step, int columns, int rows, const ClosedEdges& closed, \
                           TileScratch& scratch);                                                       \
    PigmentTotals transport_pigment(const TileScratch& scratch, const float* concentrations,            \
                                    int columns, int rows, const OpenEdges& runoff_edges,               \
                                    const PigmentCell* before, PigmentCell* after);                     \
    void concentrate(const PigmentCell* pigment, const std::int32_t* thickness, int count, float* out); \
    }

PASTOSO_DECLARE_KERNELS(baseline)
#ifdef PASTOSO_MULTIPLE_ISAS
PASTOSO_DECLARE_KERNELS(avx2)
PASTOSO_DECLARE_KERNELS(avx512)
#endif
#undef PASTOSO_DECLARE_KERNELS

TileKernels tile_kernels_for([[maybe_unused]] core::Isa isa) {
#ifdef PASTOSO_MULTIPLE_ISAS
    switch (isa) {
        case core::Isa::Avx512:
            // Pigment goes by quads of channels: measured 34 ns a cell with AVX2 code, 49 with AVX-512's masks.
            return {avx512::tile_flow, avx2::transport_pigment, avx2::concentrate};
        case core::Isa::Avx2:
            return {avx2::tile_flow, avx2::transport_pigment, avx2::concentrate};
        case core::Isa::Baseline:
            break;
    }
#endif
    return {baseline::tile_flow, baseline::transport_pigment, baseline::concentrate};
}

const TileKernels& tile_kernels() {
    static const TileKernels kernels = tile_kernels_for(core::best_isa());
    return kernels;
}

}  // namespace pastoso::film

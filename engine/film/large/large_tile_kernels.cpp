#include "film/large/large_tile_kernels.hpp"

#include "film/large/large_kernels.hpp"

namespace pastoso::film {

#define PASTOSO_LARGE_KERNELS_OF(isa)                                                             \
    LargeKernels {                                                                                \
        isa::assemble_large_tile, isa::refine_yielding, isa::compute_source, isa::compute_change, \
            isa::compute_residual, isa::correct_patch, isa::blend_corrections,                    \
            isa::compute_large_velocities, isa::cut_to_capacity, isa::share_outflow,              \
            isa::slow_limited_faces, isa::compute_large_fluxes                                    \
    }

LargeKernels large_kernels_for([[maybe_unused]] core::Isa isa) {
#ifdef PASTOSO_MULTIPLE_ISAS
    if (isa == core::Isa::Avx512) return PASTOSO_LARGE_KERNELS_OF(avx512);
    if (isa == core::Isa::Avx2) return PASTOSO_LARGE_KERNELS_OF(avx2);
#endif
    return PASTOSO_LARGE_KERNELS_OF(baseline);
}
#undef PASTOSO_LARGE_KERNELS_OF

const LargeKernels& large_kernels() {
    static const LargeKernels kernels = large_kernels_for(core::best_isa());
    return kernels;
}

}  // namespace pastoso::film

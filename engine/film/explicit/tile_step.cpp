#include "film/explicit/tile_step.hpp"

#include "film/explicit/tile_kernels.hpp"

namespace pastoso::film {

TileKernels tile_kernels_for([[maybe_unused]] core::Isa isa) {
#ifdef PASTOSO_MULTIPLE_ISAS
    switch (isa) {
        case core::Isa::Avx512:
            return {avx512::tile_flow,    avx512::transport_pigment, avx512::concentrate,
                    avx512::apply_fluxes, avx512::largest_changes,   avx512::cell_rheology};
        case core::Isa::Avx2:
            return {avx2::tile_flow,    avx2::transport_pigment, avx2::concentrate,
                    avx2::apply_fluxes, avx2::largest_changes,   avx2::cell_rheology};
        case core::Isa::Baseline:
            break;
    }
#endif
    return {baseline::tile_flow,    baseline::transport_pigment, baseline::concentrate,
            baseline::apply_fluxes, baseline::largest_changes,   baseline::cell_rheology};
}

const TileKernels& tile_kernels() {
    static const TileKernels kernels = tile_kernels_for(core::best_isa());
    return kernels;
}

}  // namespace pastoso::film

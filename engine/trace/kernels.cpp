// The hot loops that are compiled once per instruction set, and the choice among them.
#include "trace/bvh.hpp"
#include "trace/denoise_kernel.hpp"

#define PASTOSO_DECLARE_TRACE_KERNELS(isa)                              \
    namespace isa {                                                     \
    void closest(const BvhView& bvh, const MeshRay& ray, MeshHit& hit); \
    bool occluded(const BvhView& bvh, const MeshRay& ray);              \
    void average_rows(const AverageJob& job, float* scratch);           \
    inline constexpr BvhKernels kBvhKernels = {closest, occluded};      \
    inline constexpr DenoiseKernels kDenoiseKernels = {average_rows};   \
    }

namespace pastoso::trace {

PASTOSO_DECLARE_TRACE_KERNELS(baseline)
#ifdef PASTOSO_MULTIPLE_ISAS
PASTOSO_DECLARE_TRACE_KERNELS(avx2)
PASTOSO_DECLARE_TRACE_KERNELS(avx512)
#endif

const BvhKernels& bvh_kernels([[maybe_unused]] core::Isa isa) {
#ifdef PASTOSO_MULTIPLE_ISAS
    if (isa == core::Isa::Avx512) return avx512::kBvhKernels;
    if (isa == core::Isa::Avx2) return avx2::kBvhKernels;
#endif
    return baseline::kBvhKernels;
}

const DenoiseKernels& denoise_kernels([[maybe_unused]] core::Isa isa) {
#ifdef PASTOSO_MULTIPLE_ISAS
    if (isa == core::Isa::Avx512) return avx512::kDenoiseKernels;
    if (isa == core::Isa::Avx2) return avx2::kDenoiseKernels;
#endif
    return baseline::kDenoiseKernels;
}

}  // namespace pastoso::trace

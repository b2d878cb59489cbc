// The hot loops that are compiled once per instruction set, and the choice among them.
#include "trace/denoise_kernel.hpp"

#define PASTOSO_DECLARE_TRACE_KERNELS(isa)                            \
    namespace isa {                                                   \
    void average_rows(const AverageJob& job, float* scratch);         \
    inline constexpr DenoiseKernels kDenoiseKernels = {average_rows}; \
    }

namespace pastoso::trace {

PASTOSO_DECLARE_TRACE_KERNELS(baseline)
#ifdef PASTOSO_MULTIPLE_ISAS
PASTOSO_DECLARE_TRACE_KERNELS(avx2)
PASTOSO_DECLARE_TRACE_KERNELS(avx512)
#endif

const DenoiseKernels& denoise_kernels([[maybe_unused]] core::Isa isa) {
#ifdef PASTOSO_MULTIPLE_ISAS
    if (isa == core::Isa::Avx512) return avx512::kDenoiseKernels;
    if (isa == core::Isa::Avx2) return avx2::kDenoiseKernels;
#endif
    return baseline::kDenoiseKernels;
}

}  // namespace pastoso::trace

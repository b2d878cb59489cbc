#include "tank/particle_kernels.hpp"

#define PASTOSO_DECLARE_PARTICLE_KERNELS(isa)                                                       \
    namespace isa {                                                                                 \
    void scatter(const FacePairs& pairs, const void* particles, std::size_t count);                 \
    float follow(const FacePairs& pairs, const Following& how, void* particles, std::size_t count); \
    NearSums sum_near(const PositionRun* runs, int count, float reach2);                            \
    inline constexpr ParticleKernels kKernels = {scatter, follow, sum_near};                        \
    }

namespace pastoso::tank {

PASTOSO_DECLARE_PARTICLE_KERNELS(baseline)
#ifdef PASTOSO_MULTIPLE_ISAS
PASTOSO_DECLARE_PARTICLE_KERNELS(avx2)
PASTOSO_DECLARE_PARTICLE_KERNELS(avx512)
#endif

const ParticleKernels& particle_kernels([[maybe_unused]] core::Isa isa) {
#ifdef PASTOSO_MULTIPLE_ISAS
    if (isa == core::Isa::Avx512) return avx512::kKernels;
    if (isa == core::Isa::Avx2) return avx2::kKernels;
#endif
    return baseline::kKernels;
}

}  // namespace pastoso::tank

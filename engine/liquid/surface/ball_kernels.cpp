#include "liquid/surface/ball_kernels.hpp"

#define PASTOSO_DECLARE_ADD_BALLS(name) \
    void name(const BallSlab& slab, const Ball* balls, const std::uint32_t* order, std::size_t count);
#define PASTOSO_DECLARE_BALL_KERNELS(isa)                                                           \
    namespace isa {                                                                                 \
    PASTOSO_DECLARE_ADD_BALLS(add_compact)                                                          \
    PASTOSO_DECLARE_ADD_BALLS(add_cut_off)                                                          \
    PASTOSO_DECLARE_ADD_BALLS(add_near_inverse_square)                                              \
    PASTOSO_DECLARE_ADD_BALLS(add_near_inverse)                                                     \
    inline constexpr BallKernels kBallKernels = {add_compact, add_cut_off, add_near_inverse_square, \
                                                 add_near_inverse};                                 \
    }

namespace pastoso::liquid {

PASTOSO_DECLARE_BALL_KERNELS(baseline)
#ifdef PASTOSO_MULTIPLE_ISAS
PASTOSO_DECLARE_BALL_KERNELS(avx2)
PASTOSO_DECLARE_BALL_KERNELS(avx512)
#endif

const BallKernels& ball_kernels([[maybe_unused]] core::Isa isa) {
#ifdef PASTOSO_MULTIPLE_ISAS
    if (isa == core::Isa::Avx512) return avx512::kBallKernels;
    if (isa == core::Isa::Avx2) return avx2::kBallKernels;
#endif
    return baseline::kBallKernels;
}

}  // namespace pastoso::liquid

#include "liquid/flow/kernels.hpp"

#define PASTOSO_DECLARE_LIQUID_KERNELS(isa)                                                        \
    namespace isa {                                                                                \
    void relax_from_zero(const LevelView& level, int k);                                           \
    void relax(const LevelView& level, int colour, int k);                                         \
    double relax_and_multiply(const LevelView& level, int k);                                      \
    void restrict_residual(const LevelView& fine, const LevelView& coarse, int coarse_k);          \
    void add_correction(const LevelView& coarse, const LevelView& fine, int coarse_k);             \
    double start_residual(const LevelView& level, const ConjugateView& vectors, int k);            \
    DirectionSums turn_direction(const LevelView& level, const ConjugateView& vectors, float beta, \
                                 int k);                                                           \
    double advance(const LevelView& level, const ConjugateView& vectors, float alpha, float mean,  \
                   int k);                                                                         \
    double squared_source(const LevelView& level, int k);                                          \
    double total(const LevelView& level, const ColourPointers& values, int k);                     \
    void subtract(const LevelView& level, const ColourPointers& values, float mean, int k);        \
    void split_row(const LevelView& level, const float* cells, const ColourPointers& out, int j,   \
                   int k);                                                                         \
    void merge_row(const LevelView& level, const ColourPointers& in, float* cells, int j, int k);  \
    void centre_velocity(const FaceRows& faces, int count, float* out);                            \
    void advect_row(const AdvectionView& flow, const AdvectedRow& row);                            \
    void carry_points(const CarryView& flow, float* points, int count);                            \
    inline constexpr Kernels kKernels = {                                                          \
        relax_from_zero, relax,           relax_and_multiply, restrict_residual,                   \
        add_correction,  start_residual,  turn_direction,     advance,                             \
        squared_source,  total,           subtract,           split_row,                           \
        merge_row,       centre_velocity, advect_row,         carry_points};                       \
    }

namespace pastoso::liquid {

PASTOSO_DECLARE_LIQUID_KERNELS(baseline)
#ifdef PASTOSO_MULTIPLE_ISAS
PASTOSO_DECLARE_LIQUID_KERNELS(avx2)
PASTOSO_DECLARE_LIQUID_KERNELS(avx512)
#endif

const Kernels& kernels([[maybe_unused]] core::Isa isa) {
#ifdef PASTOSO_MULTIPLE_ISAS
    if (isa == core::Isa::Avx512) return avx512::kKernels;
    if (isa == core::Isa::Avx2) return avx2::kKernels;
#endif
    return baseline::kKernels;
}

const Kernels& kernels() {
    static const Kernels& best = kernels(core::best_isa());
    return best;
}

}  // namespace pastoso::liquid

// Compiled once per instruction set; see pastoso_add_kernels.
#include "liquid/flow/kernels.hpp"

namespace pastoso::liquid::PASTOSO_ISA {

void relax_from_zero(const LevelView& level, int k);
void relax(const LevelView& level, int colour, int k);
double relax_and_multiply(const LevelView& level, int k);
void restrict_residual(const LevelView& fine, const LevelView& coarse, int coarse_k);
void add_correction(const LevelView& coarse, const LevelView& fine, int coarse_k);
double start_residual(const LevelView& level, const ConjugateView& vectors, int k);
DirectionSums turn_direction(const LevelView& level, const ConjugateView& vectors, float beta, int k);
double advance(const LevelView& level, const ConjugateView& vectors, float alpha, float mean, int k);
double squared_source(const LevelView& level, int k);
double total(const LevelView& level, const ColourPointers& values, int k);
void subtract(const LevelView& level, const ColourPointers& values, float mean, int k);
void split_row(const LevelView& level, const float* cells, const ColourPointers& out, int j, int k);
void merge_row(const LevelView& level, const ColourPointers& in, float* cells, int j, int k);
void centre_velocity(const FaceRows& faces, int count, float* out);
void advect_row(const AdvectionView& flow, const AdvectedRow& row);
void carry_points(const CarryView& flow, float* points, int count);

}  // namespace pastoso::liquid::PASTOSO_ISA

PASTOSO_REGISTER_KERNELS(pastoso::liquid, Kernels, relax_from_zero, relax, relax_and_multiply,
                         restrict_residual, add_correction, start_residual, turn_direction, advance,
                         squared_source, total, subtract, split_row, merge_row, centre_velocity,
                         advect_row, carry_points)

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
void centre_velocity(const FaceRows& faces, int count, float* const* out);
void trace_row(const AdvectionView& flow, const TracedRow& row);
void advect_row(const AdvectionView& flow, const AdvectedRow& row);
void carry_points(const CarryView& flow, const CarriedPoints& points, int count);
void diffuse_cells(const FaceRows& open, const Stage& stage, const DiffusedRow& row);
void diffuse_faces(const float* open, std::ptrdiff_t stride_y, std::ptrdiff_t stride_z, bool sticks,
                   const Stage& stage, const DiffusedRow& row);
void compute_inflow(const FaceRows& open, const FaceRows& velocity, int count, float* out);
void subtract_gradient(const float* open, const float* pressure, std::ptrdiff_t stride, int count,
                       float* velocity);
double sum_of_products(const float* a, const float* b, int count);

}  // namespace pastoso::liquid::PASTOSO_ISA

PASTOSO_REGISTER_KERNELS(pastoso::liquid, Kernels, relax_from_zero, relax, relax_and_multiply,
                         restrict_residual, add_correction, start_residual, turn_direction, advance,
                         squared_source, total, subtract, split_row, merge_row, centre_velocity,
                         trace_row, advect_row, carry_points, diffuse_cells, diffuse_faces,
                         compute_inflow, subtract_gradient, sum_of_products)

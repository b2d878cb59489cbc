// The hot loops of the liquid, compiled once per instruction set and chosen at run time (core/isa.hpp).
#pragma once

#include "core/kernels.hpp"
#include "liquid/flow/advection_view.hpp"
#include "liquid/flow/field_view.hpp"
#include "liquid/pressure/multigrid_view.hpp"

namespace pastoso::liquid {

struct Kernels {
    // A multigrid level, slice k. The first colour is 0, the last 1.

    /// x = b / diagonal in the first colour, as if x were 0 all around.
    void (*relax_from_zero)(const LevelView& level, int k);
    /// Solves the equations of one colour's cells, with the other colour as it is.
    void (*relax)(const LevelView& level, int colour, int k);
    /// The same for the first colour, and the sum of value times source of both.
    double (*relax_and_multiply)(const LevelView& level, int k);
    /// The coarse slice's sources: the residuals of the fine cells of the first colour, summed. (The
    /// last colour, just relaxed, has none.)
    void (*restrict_residual)(const LevelView& fine, const LevelView& coarse, int coarse_k);
    /// Adds the coarse values to the fine cells of the first colour. (The last is relaxed next, from the
    /// first alone.)
    void (*add_correction)(const LevelView& coarse, const LevelView& fine, int coarse_k);

    // Conjugate gradients; see conjugate_gradients.hpp. All return the slice's part of a sum.

    /// source -= A solution; the sum of source^2.
    double (*start_residual)(const LevelView& level, const ConjugateView& vectors, int k);
    /// direction = z + beta direction and image = A z + beta image, both afresh where beta is 0; the sum
    /// of their product, and of the image.
    DirectionSums (*turn_direction)(const LevelView& level, const ConjugateView& vectors, float beta,
                                    int k);
    /// solution += alpha direction and source -= alpha (image - mean) where there are equations; the sum
    /// of source^2.
    double (*advance)(const LevelView& level, const ConjugateView& vectors, float alpha, float mean,
                      int k);
    double (*squared_source)(const LevelView& level, int k);

    /// The sum of a vector whose cells that take no part are 0, and the same number less in all others.
    double (*total)(const LevelView& level, const ColourPointers& values, int k);
    void (*subtract)(const LevelView& level, const ColourPointers& values, float mean, int k);

    /// From and to a row that is given cell by cell; cells that take no part become 0.
    void (*split_row)(const LevelView& level, const float* cells, const ColourPointers& out, int j,
                      int k);
    void (*merge_row)(const LevelView& level, const ColourPointers& in, float* cells, int j, int k);

    // Advection.

    /// The velocity at the middles of `count` cells, x, y and z: fourth order from the faces.
    void (*centre_velocity)(const FaceRows& faces, int count, float* const* out);
    /// The ways that lead to the samples of a row during the step.
    void (*trace_row)(const AdvectionView& flow, const TracedRow& row);
    /// Samples the fields where the samples of a row came from.
    void (*advect_row)(const AdvectionView& flow, const AdvectedRow& row);
    /// Moves whole groups of points along a velocity on faces.
    void (*carry_points)(const CarryView& flow, const CarriedPoints& points, int count);

    // Rows of fields; see diffusion.hpp and pressure.hpp.

    /// A stage of the diffusion of cell values, through the open share of each face.
    void (*diffuse_cells)(const FaceRows& open, const Stage& stage, const DiffusedRow& row);
    /// The same of face values: to open faces wholly, to shut ones as to fluid at rest or not at all.
    void (*diffuse_faces)(const float* open, std::ptrdiff_t stride_y, std::ptrdiff_t stride_z,
                          bool sticks, const Stage& stage, const DiffusedRow& row);
    /// Minus the sum of w u over the faces of each cell.
    void (*compute_inflow)(const FaceRows& open, const FaceRows& velocity, int count, float* out);
    /// u -= p - (p one stride before) on open faces; 0 on others.
    void (*subtract_gradient)(const float* open, const float* pressure, std::ptrdiff_t stride, int count,
                              float* velocity);
    /// Of floats, in double precision.
    double (*sum_of_products)(const float* a, const float* b, int count);

    static const Kernels baseline, avx2, avx512;
};

}  // namespace pastoso::liquid

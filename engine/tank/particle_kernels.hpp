// The hot loops over particles, compiled for every instruction set (pastoso_add_kernels).
#pragma once

#include "core/kernels.hpp"

#include <cstddef>

namespace pastoso::tank {

/// For each axis two numbers a face, and the box.
struct FacePairs {
    float* first[3];                    ///< of sample (0, 0, 0)
    std::ptrdiff_t stride_y, stride_z;  ///< in samples
    float size_cells[3];
    float cell_m;
};

struct Following {
    float share;  ///< of its own velocity that a particle keeps
    float dt_s;
    float gap_cells;  ///< between particles and the box' walls
};

/// Neighbouring particles, and how a mirror shows them: a place x at sign x + offset.
struct PositionRun {
    const float *x, *y, *z;  ///< in cells; there are seven more that may be read
    int count;
    float sign[3], offset[3];
};

/// Sums over particles at places p within the reach R, with w = (1 - p^2 / R^2)^3.
struct NearSums {
    float place[3];  ///< w p
    float weight;    ///< w
    float nearest2;  ///< the least p^2, at most R^2
};

struct ParticleKernels {
    /// Adds momentum and weight of each particle (tank/particle.hpp) to the faces around it.
    void (*scatter)(const FacePairs& pairs, const void* particles, std::size_t count);
    /// The pairs are the velocity now and before: see transfer.hpp. Returns the largest component of a
    /// velocity.
    float (*follow)(const FacePairs& pairs, const Following& how, void* particles, std::size_t count);
    NearSums (*sum_near)(const PositionRun* runs, int count, float reach2);

    static const ParticleKernels baseline, avx2, avx512;
};

}  // namespace pastoso::tank

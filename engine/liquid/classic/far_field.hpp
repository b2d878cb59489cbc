// The smooth part of inverse-square balls, which never end, summed over a lattice by Fourier transform.
//
// phi(q) = 1/q, q = r^2, is P(q) below Q = kNearReach^2, its Taylor polynomial of the fifth
// degree at Q, and itself beyond: five times continuously differentiable, and so smooth on the scale of
// the lattice that it may be spread by quintic B-splines. The lattice is continued by zeros to twice its
// size; what repeats with that period does not reach back.
#pragma once

#include "core/thread_pool.hpp"
#include "liquid/classic/fftw_memory.hpp"
#include "liquid/surface/ball_kernels.hpp"
#include "liquid/surface/sampled_field.hpp"

#include <vector>

namespace pastoso::liquid {

inline constexpr float kNearReach = 8.0F;  ///< in spacings

class FarField {
  public:
    /// For lattices of so many samples.
    FarField(int nx, int ny, int nz);

    bool serves(const Lattice& lattice) const;

    /// Whether a ball stands where it can be spread.
    static bool reaches(const Lattice& lattice, const Ball& ball);

    /// Adds the sums of strength phi at all samples; all balls are such that reaches() holds.
    void add(const std::vector<Ball>& balls, SampledField& field, core::ThreadPool& pool);

  private:
    struct Axis {
        int samples;  ///< of the lattice
        int slots;    ///< that balls may be spread to; slot s is sample s - 2
        int period;   ///< even, and a product of small primes
        explicit Axis(int samples);
        int frequencies() const { return period / 2 + 1; }
    };

    fftwf_complex* row(int slot_y, int slot_z) const;
    float* real_row(int slot_y, int slot_z) const { return *row(slot_y, slot_z); }
    void transform_kernel();
    void make_plans();
    void spread(const std::vector<Ball>& balls);
    void to_frequencies(core::ThreadPool& pool);
    void multiply(core::ThreadPool& pool);
    void filter_columns(int y, fftwf_complex* columns) const;
    void to_samples(SampledField& field, core::ThreadPool& pool);
    void clear(core::ThreadPool& pool);

    Axis x_, y_, z_;
    std::ptrdiff_t row_stride_;  ///< of complex numbers
    FftwReals symbol_;           ///< the kernel's transform, of frequencies from 0 to the highest
    FftwComplexes values_;       ///< slots in z, period in y, frequencies in x
    FftwComplexes columns_;      ///< of each thread; made as they are needed
    std::size_t column_threads_ = 0;
    FftwPlan x_forward_, x_back_, y_forward_, y_back_, z_forward_, z_back_;
};

}  // namespace pastoso::liquid

// Carries fields and points along a velocity.
//     q(x, t + dt) = q(X, t),  X = x - dt u(x - dt/2 u(x))
// (semi-Lagrangian, the way back by the midpoint rule), with trilinear or cubic interpolation. The way
// back reads the velocity at cells' middles, fourth order from the faces; all fields that lie at the
// same places share it.
#pragma once

#include "core/thread_pool.hpp"
#include "liquid/flow/kernels.hpp"
#include "liquid/flow/row_ranges.hpp"
#include "liquid/flow/velocity.hpp"

#include <span>

namespace pastoso::liquid {

/// A field and where its advected values go; both have two samples around the box that hold what lies
/// beyond it.
struct AdvectedPair {
    const grid::BoxField* from;
    grid::BoxField* to;
};

/// Whose ways back are found.
enum class WaysOf {
    Samples,  ///< those of each location for itself
    Cells,    ///< once for all locations: a face came the mean of the ways of both its cells
};

class Advection {
  public:
    /// The samples to advect: of each location, in the order of Location.
    Advection(const grid::BoxShape& shape, const std::array<RowRanges, 4>& rows, Edges edges,
              const Kernels& kernels = core::kernels<Kernels>(), WaysOf ways_of = WaysOf::Samples);

    /// Other samples to advect, of the same box. The velocity is to be followed anew.
    void set_rows(const std::array<RowRanges, 4>& rows);

    /// The velocity to follow. It must be known three samples around the rows and, in a periodic box,
    /// in the ghosts.
    void follow(const VelocityField& velocity, core::ThreadPool& pool);

    /// Advects fields of one location over dt_s; writes the rows' samples of `to` alone.
    void advect(std::span<const AdvectedPair> fields, Location location, float dt_s,
                Interpolation interpolation, core::ThreadPool& pool);

  private:
    /// Rows -1 to ny of slices -1 to nz.
    class RowsAround {
      public:
        explicit RowsAround(const grid::BoxShape& shape);
        RowRange& at(int j, int k) { return rows_[static_cast<std::size_t>((k + 1) * rows_y_ + j + 1)]; }
        /// Widens those rows that there are.
        void include(RowRange range, int j, int k);

      private:
        grid::BoxShape shape_;
        int rows_y_;
        std::vector<RowRange> rows_;
    };
    void compute_rows();
    AdvectionView view(float dt_s) const;
    void trace_cells(float dt_s, core::ThreadPool& pool);
    void trace_samples(Location location, float dt_s, core::ThreadPool& pool);
    void trace_row(const AdvectionView& flow, RowRange row, int j, int k, Location location);

    grid::BoxShape shape_;
    std::array<RowRanges, 4> rows_;
    Edges edges_;
    WaysOf ways_of_;
    const Kernels* kernels_;
    std::array<grid::BoxField, 3> centres_, ways_;  ///< the velocity, and the ways back
    RowsAround centre_rows_, way_rows_;
    float traced_s_ = -1.0F;  ///< of cells' ways; negative: none since the velocity was given
};

/// Moves points, in metres, over dt_s along the velocity on faces, by the midpoint rule; those that
/// leave the box are put onto its edge or, in a periodic one, to the other side. Linear or (unlimited)
/// Cubic: the cubic keeps evenly spread points from piling up at cells' borders. A point that is not a
/// number goes to the box's corner.
void carry_points(std::span<glm::vec3> points_m, const VelocityField& velocity, float dt_s, Edges edges,
                  Interpolation interpolation, core::ThreadPool& pool,
                  const Kernels& kernels = core::kernels<Kernels>());
/// The same on this thread alone.
void carry_points(std::span<glm::vec3> points_m, const VelocityField& velocity, float dt_s, Edges edges,
                  Interpolation interpolation, const Kernels& kernels = core::kernels<Kernels>());

}  // namespace pastoso::liquid

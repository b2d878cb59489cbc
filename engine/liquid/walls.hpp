// Solid walls in a box of cells: how much of each face is open to the fluid, and which cells and faces
// that leaves.
#pragma once

#include "core/thread_pool.hpp"
#include "liquid/extrapolation.hpp"
#include "liquid/row_ranges.hpp"
#include "liquid/velocity.hpp"

#include <functional>

#include <glm/vec3.hpp>

namespace pastoso::liquid {

/// The signed distance in metres of a point in metres from the wall, negative in the fluid.
using SignedDistance = std::function<float(const glm::vec3& point_m)>;

/// The longest side of a box, in cells.
inline constexpr int kMaxBoxSide_cells = 512;

/// Throws core::InputError unless every side has 2 to kMaxBoxSide_cells cells of a finite, positive
/// size.
void check_box_shape(const grid::BoxShape& shape);

/// How far values are continued into the walls, in cells: as far as the cubic's neighbours reach.
inline constexpr int kWallRings = 3;

/// The faces of the box itself are shut.
class Walls {
  public:
    /// A face's open share is clamp(1/2 - distance / cell, 0, 1) at its middle; shares under 0.02 are
    /// none, for they would make the pressure's matrix ill-conditioned. Throws core::InputError for a
    /// bad shape or a distance that is not a number.
    Walls(const grid::BoxShape& shape, const SignedDistance& distance);

    const grid::BoxShape& shape() const { return open_.shape(); }
    /// The open share of each face, 0 to 1.
    const VelocityField& open() const { return open_; }
    /// 1 in cells that have an open face, 0 in all others.
    const grid::BoxField& open_cells() const { return open_cells_; }
    /// The rows' open cells or faces, with what shut ones lie between them.
    const RowRanges& rows(Location location) const { return rows_[static_cast<std::size_t>(location)]; }
    long open_cell_count() const { return open_cell_count_; }

    /// Continues cell values, or the values on faces, kWallRings into the wall.
    void extrapolate(grid::BoxField& field, Location location, core::ThreadPool& pool) const {
        rings_[static_cast<std::size_t>(location)].apply(field, pool);
    }
    void extrapolate(VelocityField& velocity, core::ThreadPool& pool) const {
        for (const int axis : kAxes)
            extrapolate(velocity.along(axis), face_across(axis), pool);
    }

  private:
    void open_faces(const SignedDistance& distance);
    void find_open_cells();

    VelocityField open_;
    grid::BoxField open_cells_;
    std::array<RowRanges, 4> rows_;
    std::array<Extrapolation, 4> rings_;
    long open_cell_count_ = 0;
};

}  // namespace pastoso::liquid

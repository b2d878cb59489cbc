// Solid walls around the fluid in a box of cells.
#pragma once

#include "core/thread_pool.hpp"
#include "liquid/flow/extrapolation.hpp"
#include "liquid/flow/region.hpp"

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
class Walls : public Region {
  public:
    /// A face's open share is clamp(1/2 - distance / cell, 0, 1) at its middle; shares under 0.02 are
    /// none, for they would make the pressure's matrix ill-conditioned. Throws core::InputError for a
    /// bad shape or a distance that is not a number.
    Walls(const grid::BoxShape& shape, const SignedDistance& distance);

    /// Continues cell values, or the values on faces, kWallRings into the wall.
    void extrapolate(grid::BoxField& field, Location location, core::ThreadPool& pool) const {
        rings_[static_cast<std::size_t>(location)].apply(field, pool);
    }
    void extrapolate(VelocityField& velocity, core::ThreadPool& pool) const {
        for (const int axis : kAxes)
            extrapolate(velocity.along(axis), face_across(axis), pool);
    }

  private:
    std::array<Extrapolation, 4> rings_;
};

}  // namespace pastoso::liquid

// The domain of a tank's liquid: the box less the solids that stand in it.
#pragma once

#include "liquid/flow/walls.hpp"

#include <functional>

namespace pastoso::tank {

/// The velocity of faces less open than this is not trusted: what little passes them makes it any size.
inline constexpr float kTrustedShare = 0.2F;

/// The cells in which liquid can be, and what a velocity may do near a solid. The faces of the box are
/// shut; solids are cut cells (liquid::Walls).
class Domain {
  public:
    /// `solid_m` is the signed distance from the solids in metres, negative within them. Throws
    /// InputError for a bad shape or a distance that is not a number.
    Domain(const grid::BoxShape& shape, const liquid::SignedDistance& solid_m);

    const grid::BoxShape& shape() const { return walls_.shape(); }
    const liquid::Walls& walls() const { return walls_; }
    /// Share of each cell that no solid takes, 0 to 1: clamp(1/2 + distance / cell, 0, 1).
    const grid::BoxField& share() const { return share_; }
    /// The distance from the solids, positive in the domain, at the middles of cells and of the ghosts.
    const grid::BoxField& distance_m() const { return distance_m_; }
    bool has_solids() const { return has_solids_; }
    /// The same at a point in the box, interpolated.
    float free_m(const glm::vec3& point_m) const;

    /// A point in the box brought at least `margin_m` out of solids, along their normals, and as far
    /// within the box.
    glm::vec3 brought_within(glm::vec3 point_m, float margin_m) const;

    /// A point beyond the box' walls or within a solid as a mirror there would show it: as far in the
    /// domain.
    glm::vec3 mirrored_out(glm::vec3 point_m) const;

    /// Sets the velocity on the box's own faces to 0, and takes away on faces that solids shut, all or
    /// nearly, what of it points into them. The velocity must be known around those faces.
    void stop_at_walls(const liquid::RowRanges& samples, liquid::VelocityField& velocity,
                       core::ThreadPool& pool) const;

  private:
    struct ShutFace {
        int i, j, k;
        glm::vec3 normal;  ///< into the domain
    };
    void compute_shut_faces();
    glm::vec3 normal_at(const glm::vec3& point_m) const;

    liquid::Walls walls_;
    grid::BoxField share_, distance_m_;
    std::array<std::vector<ShutFace>, 3> shut_faces_;  ///< of solids, near the domain
    bool has_solids_ = false;
};

}  // namespace pastoso::tank

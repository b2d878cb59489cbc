// Continues the velocity of the liquid along the normals of its surface into the air:
//     grad phi . grad u = 0
// for each component on its own faces. Faces are taken in the order of their phi; each becomes the mean
// of its neighbours with smaller phi, one along each axis, weighted by how much smaller: the upwind
// solution of the equation (Adalsteinsson and Sethian, J. Comput. Phys. 148, 1999), which the source's
// iteration tends to, in one pass.
#pragma once

#include "core/thread_pool.hpp"
#include "liquid/flow/velocity.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace pastoso::tank {

/// As far as a way back of a cell from within the reach reads the velocity (liquid/advection.hpp).
inline constexpr int kMeanRings = 3;

class VelocityExtension {
  public:
    explicit VelocityExtension(const grid::BoxShape& shape);

    /// Sets the faces of the box that are not known (known <= 0) and less than reach_cells from the
    /// liquid, those in it among them; phi must be a distance that far. Those without a known way to the
    /// liquid, and kMeanRings rings of faces beyond the reach, become means of their neighbours; all
    /// others stay, and all of a region in which nothing is known. Exact for constants, and within the
    /// reach for linear fields that are constant along the normals of a plane. phi's first sample around
    /// the box is read; the velocity's belong to whoever knows the walls (liquid::Walls::extrapolate).
    void extend(const grid::BoxField& phi, const liquid::VelocityField& known, float reach_cells,
                liquid::VelocityField& velocity, core::ThreadPool& pool);

  private:
    struct Face {
        std::uint32_t key;    ///< orders as phi does
        std::uint32_t index;  ///< of the sample
    };
    /// What one component needs; kept between calls.
    struct Component {
        std::vector<Face> faces, sorted;
        std::vector<std::uint32_t> left;    ///< faces without a way to the liquid
        std::vector<std::uint32_t> ring;    ///< faces that are set from those settled so far
        std::vector<std::uint8_t> settled;  ///< of each sample: a Settled
        grid::BoxField phi;                 ///< on the faces
    };

    enum Settled : std::uint8_t {
        kNo,
        kYes,
        kInRing,   ///< not yet
        kOutside,  ///< of the box
    };

    void compute_faces(Component& component, int axis, const grid::BoxField& phi,
                       const grid::BoxField& known, float reach_m) const;
    static void sort(Component& component);
    void settle(Component& component, grid::BoxField& values) const;
    void settle_left(Component& component, grid::BoxField& values) const;
    void settle_rings(Component& component, float reach_m, grid::BoxField& values) const;
    void settle_by_means(Component& component, grid::BoxField& values) const;

    grid::BoxShape shape_;
    std::array<Component, 3> components_;
};

}  // namespace pastoso::tank

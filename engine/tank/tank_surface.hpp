// The surface of a tank's liquid as triangles, cut where glass and solids begin.
#pragma once

#include "liquid/surface/marching_cubes.hpp"
#include "tank/tank_frame.hpp"

namespace pastoso::tank {

/// Keeps its working memory from one frame to the next.
class TankSurfaces {
  public:
    /// The domain outlives the surfaces.
    TankSurfaces(const Domain& domain, core::ThreadPool& pool)
        : domain_(&domain), pool_(pool), cubes_(pool) {}

    /// The closed surface of the liquid with normals. It ends `reach_m` (0 to half a cell) within the
    /// walls, the floor and the solids, and at the top of the box: with 0 it encloses the liquid there
    /// is, to second order of the lattice's spacing; for pictures it shall reach into the glass. Where
    /// the liquid is thinner than the spacing, its edge draws back from the wall by less than that.
    /// `mesh` is overwritten.
    void make(const TankFrame& frame, float reach_m, liquid::TriangleMesh& mesh);

    /// Of the last one: how far along x the liquid has come. All but a 2000th of it lies before that,
    /// so that spray does not count. 0 where there is none.
    double front_x_m() const;

  private:
    void compute_domain(const liquid::Lattice& lattice, float reach_m);

    const Domain* domain_;
    core::ThreadPool& pool_;
    liquid::MarchingCubes cubes_;
    liquid::SampledField domain_m_;  ///< distance from what cuts the liquid, positive where it may be
    liquid::SampledField cut_m_;
    float reach_m_ = -1.0F;  ///< of domain_m_
};

}  // namespace pastoso::tank

// The surface of the milk that has not dissolved: metaballs of the parcels, cut by the cup, so large
// that they hold the parcels' volume.
#pragma once

#include "liquid/surface/marching_cubes.hpp"
#include "liquid/surface/metaballs.hpp"
#include "liquid/surface/triangle_mesh.hpp"
#include "liquid/vessel/cup.hpp"

#include <span>
#include <vector>

namespace pastoso::liquid {

struct MilkSurfaceSettings {
    Metaballs balls;           ///< the smallest compact balls reach `least_reach` spacings
    int parts = 2;             ///< samples along the side of a cell of the simulation, 1 to 8
    float least_reach = 1.2F;  ///< so that no ball slips through the lattice
    float gap_m = 0.00015F;    ///< how far the milk stays within the glass and below the level, >= 0
    double volume_tolerance = 5e-3;  ///< the search for the threshold ends there
    int most_tries = 16;             ///< or after so many thresholds
    core::Isa isa = core::best_isa();
};

struct MilkSurface {
    TriangleMesh mesh;        ///< closed, with normals; empty where there is no milk
    float threshold = 0.0F;   ///< of the field
    double parcels_m3 = 0.0;  ///< what the mesh should hold
    double mesh_m3 = 0.0;     ///< what it holds
    int tries = 0;

    /// By how much the mesh holds too much (> 0) or too little, as a share. Some clouds have no surface
    /// of their volume: parcels all at one place reach no farther than their kernel.
    double volume_error() const { return parcels_m3 > 0.0 ? mesh_m3 / parcels_m3 - 1.0 : 0.0; }
};

/// Keeps its working memory, and the cup on the lattice, from one frame to the next.
class MilkSurfaces {
  public:
    explicit MilkSurfaces(core::ThreadPool& pool) : pool_(pool), balls_(pool), cubes_(pool) {}

    /// The surface of {f > threshold} where the tea's distance is below -gap, sampled at the middles of
    /// cells that are `parts` times finer than the simulation's; what lies at its outermost samples is
    /// left out. The threshold is searched between bounds by false position (Illinois). The same bits
    /// for any number of threads and any instruction set, but for kernels without end (metaballs.hpp).
    MilkSurface make(std::span<const Parcel> parcels, const Cup& cup, const grid::BoxShape& shape,
                     const MilkSurfaceSettings& settings = {});

  private:
    void sample_cup(const Cup& cup, const Lattice& lattice, float gap_m);
    void compute_milk();
    void cut(float threshold);
    double volume_at(float threshold, const MilkSurfaceSettings& settings, TriangleMesh& mesh);

    core::ThreadPool& pool_;
    MetaballField balls_;
    MarchingCubes cubes_;
    SampledField field_, inside_, cut_;  ///< of the balls; within the cup > 0; their intersection
    std::vector<char> has_milk_;       ///< of each row
    Cup cup_;
    float gap_m_ = -1.0F;
};

}  // namespace pastoso::liquid

// The system of "Rendering Milk Tea" (2010): a force that swirls around an upright axis and pushes down,
// in a periodic box, and particles that float along. On its own lattice (source_lattice.hpp), moved by
// Euler's rule, they pile up; on the product's periodic flow, moved by the midpoint rule, they do not.
// pile_up() measures it.
#pragma once

#include "core/thread_pool.hpp"
#include "liquid/classic/periodic.hpp"
#include "liquid/classic/source_lattice.hpp"
#include "liquid/tea/parcel.hpp"

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace pastoso::liquid {

enum class ClassicSolver {
    Source,   ///< as it was
    Product,  ///< what the program uses today
};

struct ClassicSettings {
    ClassicSolver solver = ClassicSolver::Source;
    int cells = 6;         ///< along each side, 4 to 256
    int particles = 1000;  ///< evenly spread at first, 1 to kMaxParcels
    float box_m = 0.1F;
    float step_s = 1.0F / 30.0F;
    float viscosity_m2_s = 1e-5F;  ///< 0 and more
    float swirl_rad_s2 = 4.0F;     ///< acceleration around the axis, per metre from it
    float push_m_s2 = 0.02F;       ///< downwards
    glm::vec2 axis_m{0.05F, 0.05F};
    std::uint32_t seed = 1;
};

/// Throws core::InputError for a number outside its range.
void check_classic(const ClassicSettings& settings);

class ClassicTea {
  public:
    /// At rest. Throws core::InputError like check_classic().
    explicit ClassicTea(const ClassicSettings& settings);

    void step(core::ThreadPool& pool);

    const ClassicSettings& settings() const { return settings_; }
    int steps() const { return steps_; }
    double time_s() const { return steps_ * static_cast<double>(settings_.step_s); }
    const std::vector<glm::vec3>& particles_m() const { return particles_m_; }
    /// The particles as balls of equal size, for metaballs.
    std::vector<Parcel> parcels() const;

  private:
    void step_on(SourceLattice& flow, core::ThreadPool& pool);
    void step_on(PeriodicFlow& flow, core::ThreadPool& pool);
    glm::vec3 force_over_step(const glm::vec3& point_m) const;

    ClassicSettings settings_;
    std::variant<SourceLattice, PeriodicFlow> flow_;
    std::vector<glm::vec3> particles_m_;
    int steps_ = 0;
};

/// How unevenly points lie in a periodic box.
struct PileUp {
    /// Share of coordinates that lie within a tenth of a voxel of a plane through lattice points, over
    /// the 0.2 that evenly spread points have.
    double at_borders = 0.0;
    /// Variance over mean of the numbers of points in the voxels; 1 for points spread by chance, 0 for
    /// the same number everywhere.
    double dispersion = 0.0;
};

/// Of a lattice with so many points along each side of the box, at the middles of its cells.
PileUp pile_up(std::span<const glm::vec3> points_m, int cells, float box_m);

}  // namespace pastoso::liquid

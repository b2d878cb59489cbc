// Milk in the liquid as a scattering medium: its volume fraction between the cells' centres, and what
// light meets on the way through it.
#pragma once

#include "grid/block_field.hpp"
#include "trace/sampler.hpp"

#include <vector>

#include <glm/vec3.hpp>

namespace pastoso::trace {

class DissolvedMilk {
  public:
    DissolvedMilk() = default;
    /// `scattering_per_m` is what a volume fraction of 1 scatters.
    DissolvedMilk(grid::BlockField fraction, float scattering_per_m);

    bool empty() const { return fraction_.empty(); }

    /// Volume fraction, trilinear between the centres of the cells, and beyond them that of the nearest.
    float fraction(const glm::vec3& point_m) const { return fraction_.between(point_m * per_cell_); }

    struct FreePath {
        float length_m;  ///< before the ray is scattered, or the limit
        float milk_m;    ///< the integral of the fraction along it
    };
    /// By delta tracking (Woodcock et al. 1965) with a bound b of the scattering for each block of
    /// cells; the fraction over b, added up where it is looked at, has its integral as mean (Campbell
    /// 1909). There is milk up to a cell beyond the field, and no farther.
    FreePath free_path(const glm::vec3& origin_m, const glm::vec3& direction, float limit_m,
                       Sampler& sampler) const;

    /// The share of light that is not scattered within `length_m`, by samples at even distances from a
    /// random start; biased upwards by less than their spacing lets it vary.
    float transmittance(const glm::vec3& origin_m, const glm::vec3& direction, float length_m,
                        Sampler& sampler) const;

  private:
    struct Walk;
    void note_bounds(const glm::ivec3& block);
    int block_index(const glm::vec3& point_m) const;
    float way_out_m(const glm::vec3& origin_m, const glm::vec3& direction) const;

    grid::BlockField fraction_;
    glm::ivec3 cells_{0}, blocks_{0};  ///< blocks_: those that have bounds
    float per_cell_ = 0.0F, block_m_ = 0.0F, scattering_per_m_ = 0.0F, spacing_m_ = 0.0F;
    std::vector<float> bound_per_m_;  ///< of the scattering in each block
};

}  // namespace pastoso::trace

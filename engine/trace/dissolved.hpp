// Dissolved milk as a scattering medium: its volume fraction between the cells' centres, and what light
// meets on the way through it.
#pragma once

#include "grid/box_field.hpp"
#include "trace/sampler.hpp"

#include <vector>

#include <glm/vec3.hpp>

namespace pastoso::trace {

class DissolvedMilk {
  public:
    DissolvedMilk() = default;
    /// `scattering_per_m` is what a volume fraction of 1 scatters.
    DissolvedMilk(const grid::BoxField& fraction, float scattering_per_m);

    bool empty() const { return values_.empty(); }

    /// Volume fraction, trilinear between the centres of the cells, and beyond them that of the nearest.
    float fraction(const glm::vec3& point_m) const;

    /// How far a ray gets before it is scattered, or `limit_m`: delta tracking (Woodcock et al. 1965)
    /// with a bound of the scattering for each block of cells. There is milk up to a cell beyond the
    /// field, and no farther.
    float free_path_m(const glm::vec3& origin_m, const glm::vec3& direction, float limit_m,
                      Sampler& sampler) const;

    /// The share of light that is not scattered within `length_m`, by samples at even distances from a
    /// random start; biased upwards by less than their spacing lets it vary.
    float transmittance(const glm::vec3& origin_m, const glm::vec3& direction, float length_m,
                        Sampler& sampler) const;

  private:
    struct Walk;
    int block_index(const glm::vec3& point_m) const;
    float way_out_m(const glm::vec3& origin_m, const glm::vec3& direction) const;

    glm::ivec3 cells_{0}, blocks_{0};
    float per_cell_ = 0.0F, block_m_ = 0.0F, scattering_per_m_ = 0.0F, spacing_m_ = 0.0F;
    std::vector<float> values_;       ///< without ghosts
    std::vector<float> bound_per_m_;  ///< of the scattering in each block
};

}  // namespace pastoso::trace

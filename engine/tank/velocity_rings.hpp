// Continues a velocity from the faces where it is known into the air and the solids around them, ring by
// ring: each face becomes the mean of its known neighbours across the same axis. For particles, which
// stay within two cells of the faces that are known; a level set needs tank/extension.hpp.
#pragma once

#include "core/thread_pool.hpp"
#include "liquid/flow/row_ranges.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace pastoso::tank {

/// What is known of a face: nothing, the velocity of particles that fly there, or the velocity of the
/// liquid beside it. Flying ones count from the second ring on: what floats on the liquid moves with it.
inline constexpr float kUnknownFace = 0.0F, kFlyingFace = 1.0F, kLiquidFace = 2.0F;

class VelocityRings {
  public:
    explicit VelocityRings(const grid::BoxShape& shape);

    /// `known` is one of the above on each face within `samples`; beyond them nothing is known. The same
    /// bits on any number of threads.
    void extend(const liquid::VelocityField& known, const liquid::RowRanges& samples, int rings,
                liquid::VelocityField& velocity, core::ThreadPool& pool);

  private:
    struct Target {
        std::ptrdiff_t index;
        float value;
    };
    /// What a component needs.
    struct Component {
        std::vector<std::uint8_t> known;           ///< of each face
        std::vector<std::vector<Target>> targets;  ///< of each slice
    };
    void load(const grid::BoxField& known, const liquid::RowRanges& samples, int k,
              Component& component) const;
    void add_flying(const grid::BoxField& known, int k, Component& component) const;
    void compute_targets(const grid::BoxField& field, const liquid::RowRanges& samples, int k,
                         Component& component) const;
    static void apply(grid::BoxField& field, int k, Component& component);

    grid::BoxShape shape_;
    liquid::RowRanges used_;  ///< what rows of the masks may not be 0
    std::array<Component, 3> components_;
};

}  // namespace pastoso::tank

// The light that passes through the tea at each place, from all directions.
#pragma once

#include "grid/box_field.hpp"
#include "liquid/vessel/cup.hpp"
#include "trace/light_sums.hpp"

#include <vector>

#include <glm/vec3.hpp>

namespace pastoso::trace {

/// Fluence: radiance integrated over all directions. Gathered as the length of photons' ways through a
/// cell, times their power, over the volume of tea in it.
class FluenceField {
  public:
    /// Nothing anywhere.
    FluenceField() = default;
    /// `ways` holds power times length, in units of `unit`, of the cells of `shape`, x first.
    FluenceField(const grid::BoxShape& shape, const liquid::Cup& cup, const LightSums& ways, float unit);

    bool empty() const { return cells_.empty(); }

    /// Of the eight cells around, each by its share and its volume of tea.
    glm::vec3 at(const glm::vec3& point_m) const;

  private:
    struct Cell {
        glm::vec3 ways{0.0F};    ///< power times length, over the volume of a whole cell
        float tea_share = 0.0F;  ///< of its volume
    };
    void smooth(int count, std::size_t stride);

    grid::BoxShape shape_;
    std::vector<Cell> cells_;
};

}  // namespace pastoso::trace

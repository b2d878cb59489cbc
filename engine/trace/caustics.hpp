// Light of the lamp that glass and liquid throw onto the table.
#pragma once

#include "trace/light_sums.hpp"

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace pastoso::trace {

/// A square of the table that is looked at in cells, its sides along x and y.
struct TableSquare {
    glm::vec2 low_m{0.0F};
    float cell_m = 0.0F;
    int side_cells = 0;

    /// Of the cell at a place, x first; -1 beyond the square.
    int cell(const glm::vec2& place_m) const;
};

/// Irradiance on a square of the table, smoothed over a few cells; nothing beyond it.
class Caustics {
  public:
    Caustics() = default;
    /// `arrived` holds the power that came into each cell, in units of `unit`.
    Caustics(const TableSquare& square, const LightSums& arrived, float unit);

    bool empty() const { return irradiance_.empty(); }
    glm::vec3 irradiance(const glm::vec2& place_m) const;

  private:
    void smooth();

    TableSquare square_;
    std::vector<glm::vec3> irradiance_;
};

}  // namespace pastoso::trace

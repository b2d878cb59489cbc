// Makes phi the distance from its own surface again without moving the surface.
//
// Every cell beside the surface finds the closest point of the interpolant's zero (zero_set.hpp). Cells
// farther away take the closest of the points that their neighbours found, ring by ring, and seek on
// from there. So the distance is exact up to the interpolant everywhere in the band, and the work
// follows the surface.
#pragma once

#include "core/thread_pool.hpp"
#include "grid/box_field.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace pastoso::tank {

class Reinitialisation {
  public:
    explicit Reinitialisation(const grid::BoxShape& shape);

    /// |phi| becomes the distance from the surface, at most reach_cells (1 or more); no sign changes.
    /// A field of one sign becomes plus or minus the reach. Values beside the surface that are off by
    /// less than kept_within_cells stay as they are, and with them the surface, bit for bit: 0 measures
    /// them all. Measuring costs sheets less than two cells thick some of their volume each time.
    void apply(grid::BoxField& phi, float reach_cells, float kept_within_cells, core::ThreadPool& pool);

  private:
    struct Cell {
        std::int16_t i, j;
        std::int32_t ring;
        float distance_cells;
        glm::vec3 foot;   ///< closest point of the surface found so far, in cell units
        glm::vec3 start;  ///< where to seek it from
    };
    using Slice = std::vector<Cell>;

    void compute_first_ring(const grid::BoxField& phi, core::ThreadPool& pool);
    void add_ring(int ring, float reach_cells, core::ThreadPool& pool);
    void look_around(core::ThreadPool& pool);
    void seek(const grid::BoxField& phi, float reach_cells, core::ThreadPool& pool);
    void write(grid::BoxField& phi, float reach_cells, float kept_within_cells, core::ThreadPool& pool);

    void push_neighbours(const Slice& previous, int ring, float reach_cells, int k, Slice& added);
    glm::vec3 closest_of_neighbours(const Cell& cell, int k, int rings) const;

    grid::BoxShape shape_;
    std::vector<std::int32_t> slots_;  ///< of each sample, where its cell stands in its slice; -1: none
    std::vector<Slice> slices_, added_;
};

}  // namespace pastoso::tank

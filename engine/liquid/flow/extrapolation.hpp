// Continues a field from the samples where it is known into those around them, ring by ring: each sample
// becomes the mean of its neighbours in the rings before.
#pragma once

#include "core/thread_pool.hpp"
#include "grid/box_field.hpp"

#include <cstdint>
#include <vector>

namespace pastoso::liquid {

class Extrapolation {
  public:
    Extrapolation() = default;
    /// Known samples are those with known > 0. Reaches one sample beyond the box at most.
    Extrapolation(const grid::BoxField& known, int rings);

    void apply(grid::BoxField& field, core::ThreadPool& pool) const;

  private:
    struct Target {
        std::uint32_t index;
        std::uint32_t neighbours;  ///< which of the six are known: bit 2 axis + (0 before, 1 behind)
    };
    void add_ring(const grid::BoxShape& shape, std::vector<std::uint8_t>& known);
    void fill(grid::BoxField& field, std::size_t begin, std::size_t end) const;

    std::vector<Target> targets_;
    std::vector<std::size_t> ring_ends_;
};

}  // namespace pastoso::liquid

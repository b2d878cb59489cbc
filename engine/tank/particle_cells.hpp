// Which particles are in which cell: they are kept in the order of the cells, so that whatever works on
// neighbours reads neighbouring memory.
#pragma once

#include "core/thread_pool.hpp"
#include "liquid/flow/aligned_floats.hpp"
#include "liquid/flow/row_ranges.hpp"
#include "tank/particle.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace pastoso::tank {

class ParticleCells {
  public:
    explicit ParticleCells(const grid::BoxShape& shape);

    /// Puts the particles into the order of their cells, x fastest; those of one cell keep their order.
    /// Positions must be finite and within the box. The same order on any number of threads.
    void sort(std::vector<Particle>& particles, core::ThreadPool& pool);

    /// Particles [begin(i, j, k), end(i, j, k)) are in the cell; those of neighbours along x follow.
    std::uint32_t begin(int i, int j, int k) const { return starts_[cell(i, j, k)]; }
    std::uint32_t end(int i, int j, int k) const { return starts_[cell(i, j, k) + 1]; }
    /// The first particle of slice k and those above; k may be nz.
    std::uint32_t slice_begin(int k) const { return slice_begins_[static_cast<std::size_t>(k)]; }
    /// Where the particles are, in cells, an axis after the other; after the last there are seven more
    /// numbers that may be read.
    const liquid::AlignedFloats& places(int axis) const {
        return places_[static_cast<std::size_t>(axis)];
    }
    /// Hulls of the cells that have particles.
    const liquid::RowRanges& rows() const { return rows_; }

  private:
    std::size_t cell(int i, int j, int k) const {
        return static_cast<std::size_t>((k * shape_.ny + j) * shape_.nx + i);
    }
    void count_slices(const std::vector<Particle>& particles, core::ThreadPool& pool);
    void order_by_slice(std::size_t count, core::ThreadPool& pool);
    void order_slice(int k, const std::vector<Particle>& particles);

    grid::BoxShape shape_;
    std::vector<std::uint32_t> starts_;  ///< of each cell, and the number of all
    std::vector<std::uint32_t> slice_begins_;
    std::array<liquid::AlignedFloats, 3> places_;
    liquid::RowRanges rows_;

    // What a sort works with.
    std::vector<std::uint32_t> cells_, order_;  ///< of each particle its cell; particles by slice
    std::vector<std::uint16_t> slices_;         ///< of each particle
    std::vector<std::uint32_t> slice_starts_;   ///< of each part and slice
    std::vector<std::uint32_t> next_;           ///< of each cell
    std::vector<Particle> sorted_;
};

}  // namespace pastoso::tank

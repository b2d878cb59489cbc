#include "tank/particle_cells.hpp"

#include "core/check.hpp"
#include "liquid/flow/slices.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::tank {
namespace {

/// Particles are counted in so many parts, whatever the number of threads: their order depends on it.
constexpr std::size_t kParts = 32;
constexpr std::size_t kMoreThatMayBeRead = 7;

std::size_t part_begin(std::size_t part, std::size_t count) {
    return part * count / kParts;
}

}  // namespace

ParticleCells::ParticleCells(const grid::BoxShape& shape)
    : shape_(shape),
      starts_(cell(0, 0, shape.nz) + 1, 0),
      slice_begins_(static_cast<std::size_t>(shape.nz) + 1, 0),
      rows_(shape),
      slice_starts_(kParts * static_cast<std::size_t>(shape.nz)),
      next_(cell(0, 0, shape.nz)) {}

void ParticleCells::sort(std::vector<Particle>& particles, core::ThreadPool& pool) {
    cells_.resize(particles.size());
    order_.resize(particles.size());
    slices_.resize(particles.size());
    sorted_.resize(particles.size());
    for (auto& places : places_)
        places.resize(particles.size() + kMoreThatMayBeRead);
    count_slices(particles, pool);
    order_by_slice(particles.size(), pool);
    liquid::for_slices(pool, 0, shape_.nz, [&](int k) { order_slice(k, particles); });
    particles.swap(sorted_);
}

void ParticleCells::count_slices(const std::vector<Particle>& particles, core::ThreadPool& pool) {
    const float per_cell = 1.0F / shape_.cell_m;
    const auto slices = static_cast<std::size_t>(shape_.nz);
    pool.run(kParts, [&](std::size_t part, int) {
        std::uint32_t* counts = slice_starts_.data() + part * slices;
        std::fill_n(counts, slices, 0U);
        for (std::size_t p = part_begin(part, particles.size());
             p < part_begin(part + 1, particles.size()); ++p) {
            const glm::vec3 at = particles[p].position_m * per_cell;
            const int i = std::clamp(static_cast<int>(at.x), 0, shape_.nx - 1),
                      j = std::clamp(static_cast<int>(at.y), 0, shape_.ny - 1),
                      k = std::clamp(static_cast<int>(at.z), 0, shape_.nz - 1);
            cells_[p] = static_cast<std::uint32_t>(cell(i, j, k));
            slices_[p] = static_cast<std::uint16_t>(k);
            ++counts[k];
        }
    });
    std::uint32_t before = 0;
    for (std::size_t k = 0; k < slices; ++k) {
        slice_begins_[k] = before;
        for (std::size_t part = 0; part < kParts; ++part) {
            std::uint32_t& start = slice_starts_[part * slices + k];
            before += std::exchange(start, before);
        }
    }
    slice_begins_[slices] = starts_.back() = before;
}

void ParticleCells::order_by_slice(std::size_t count, core::ThreadPool& pool) {
    const auto slices = static_cast<std::size_t>(shape_.nz);
    pool.run(kParts, [&](std::size_t part, int) {
        std::uint32_t* next = slice_starts_.data() + part * slices;
        for (std::size_t p = part_begin(part, count); p < part_begin(part + 1, count); ++p)
            order_[next[slices_[p]]++] = static_cast<std::uint32_t>(p);
    });
}

void ParticleCells::order_slice(int k, const std::vector<Particle>& particles) {
    const std::size_t first = cell(0, 0, k), last = cell(0, 0, k + 1);
    const std::uint32_t begin = slice_begin(k), end = slice_begin(k + 1);
    std::fill(next_.begin() + static_cast<std::ptrdiff_t>(first),
              next_.begin() + static_cast<std::ptrdiff_t>(last), 0U);
    for (std::uint32_t at = begin; at < end; ++at)
        ++next_[cells_[order_[at]]];
    const float per_cell = 1.0F / shape_.cell_m;
    std::uint32_t before = begin;
    for (int j = 0; j < shape_.ny; ++j) {
        rows_.at(j, k) = {};
        for (int i = 0; i < shape_.nx; ++i) {
            std::uint32_t& next = next_[cell(i, j, k)];
            if (next > 0) rows_.include(i, j, k);
            starts_[cell(i, j, k)] = before;
            before += std::exchange(next, before);
        }
    }
    PASTOSO_CHECK_OP(before, ==, end);
    for (std::uint32_t at = begin; at < end; ++at) {
        const std::uint32_t p = order_[at];
        const std::uint32_t to = next_[cells_[p]]++;
        sorted_[to] = particles[p];
        for (const int axis : liquid::kAxes)
            places_[static_cast<std::size_t>(axis)][to] = particles[p].position_m[axis] * per_cell;
    }
}

}  // namespace pastoso::tank

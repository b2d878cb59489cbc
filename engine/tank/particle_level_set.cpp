#include "tank/particle_level_set.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "liquid/flow/sample_lanes.hpp"
#include "liquid/flow/slices.hpp"
#include "tank/level_set.hpp"

#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace pastoso::tank {
namespace {

constexpr std::size_t kBlock = 4096;

/// Trilinear, of a point in the box.
float phi_at(const grid::BoxField& phi, const glm::vec3& point_m) {
    const grid::BoxShape& shape = phi.shape();
    const float per_cell = 1.0F / shape.cell_m;
    const liquid::Four at = {point_m.x * per_cell - 0.5F, point_m.y * per_cell - 0.5F,
                             point_m.z * per_cell - 0.5F, 0.0F};
    const std::ptrdiff_t y = shape.stride_y(), z = shape.stride_z();
    return liquid::linear(phi.row(0, 0), liquid::place_of(at, y, z), y, z);
}

bool escaped(float phi_m, float signed_radius_m) {
    return signed_radius_m > 0.0F ? phi_m < -signed_radius_m : phi_m > -signed_radius_m;
}

int cell_along(float position_m, float cell_m, int count) {
    return std::clamp(static_cast<int>(position_m / cell_m), 0, count - 1);
}

}  // namespace

SurfaceParticles::SurfaceParticles(const grid::BoxShape& shape, const SurfaceParticleSettings& settings)
    : shape_(shape), settings_(settings), slots_(shape.sample_count(), -1) {
    PASTOSO_CHECK_OP(settings.per_cell, >=, 1);
    PASTOSO_CHECK_OP(settings.per_cell, <=, 64);
    PASTOSO_CHECK_OP(settings.least_radius_cells, >, 0.0F);
}

float SurfaceParticles::signed_radius_m(float phi_m, bool in_air) const {
    const float depth_cells = (in_air ? phi_m : -phi_m) / shape_.cell_m;
    const float radius_m = shape_.cell_m * std::clamp(depth_cells, settings_.least_radius_cells,
                                                      settings_.most_radius_cells);
    return in_air ? radius_m : -radius_m;
}

void SurfaceParticles::seed(const grid::BoxField& phi, core::ThreadPool& pool) {
    positions_m_.clear();
    signed_radii_m_.clear();
    reseed(phi, pool);
}

void SurfaceParticles::carry(const liquid::VelocityField& velocity, float dt_s, core::ThreadPool& pool) {
    liquid::carry_points(positions_m_, velocity, dt_s, liquid::Edges::Walls, settings_.interpolation,
                         pool);
}

std::size_t SurfaceParticles::mend(grid::BoxField& phi, core::ThreadPool& pool) {
    PASTOSO_CHECK(phi.shape() == shape_);
    const std::size_t blocks = (positions_m_.size() + kBlock - 1) / kBlock;
    std::vector<std::vector<std::uint32_t>> escaped_of(blocks);
    pool.run(blocks, [&](std::size_t block, int) {
        const std::size_t end = std::min(positions_m_.size(), (block + 1) * kBlock);
        for (std::size_t p = block * kBlock; p < end; ++p)
            if (escaped(phi_at(phi, positions_m_[p]), signed_radii_m_[p]))
                escaped_of[block].push_back(static_cast<std::uint32_t>(p));
    });
    std::size_t count = 0;
    claims_.clear();
    for (const auto& list : escaped_of) {
        count += list.size();
        for (const std::uint32_t particle : list)
            claim(phi, particle);
    }
    float* values = phi.values().data();
    for (const Claim& claim : claims_) {
        values[claim.index] =
            std::abs(claim.air_m) <= std::abs(claim.liquid_m) ? claim.air_m : claim.liquid_m;
        slots_[claim.index] = -1;
    }
    continue_beyond_walls(phi);
    return count;
}

void SurfaceParticles::claim(const grid::BoxField& phi, std::uint32_t particle) {
    const glm::vec3 at = positions_m_[particle] / shape_.cell_m - 0.5F;
    const float radius_m = signed_radii_m_[particle];
    const int lower[3] = {static_cast<int>(at.x + 1.0F) - 1, static_cast<int>(at.y + 1.0F) - 1,
                          static_cast<int>(at.z + 1.0F) - 1};
    for (int corner = 0; corner < 8; ++corner) {
        const int i = lower[0] + (corner & 1), j = lower[1] + (corner >> 1 & 1),
                  k = lower[2] + (corner >> 2);
        if (i < 0 || j < 0 || k < 0 || i >= shape_.nx || j >= shape_.ny || k >= shape_.nz) continue;
        const auto index = static_cast<std::uint32_t>(shape_.index(i, j, k));
        std::int32_t& slot = slots_[index];
        if (slot < 0) {
            slot = static_cast<std::int32_t>(claims_.size());
            claims_.push_back({index, phi.values()[index], phi.values()[index]});
        }
        Claim& claim = claims_[static_cast<std::size_t>(slot)];
        const glm::vec3 middle(static_cast<float>(i), static_cast<float>(j), static_cast<float>(k));
        const float distance_m = glm::length(middle - at) * shape_.cell_m;
        if (radius_m > 0.0F)
            claim.air_m = std::max(claim.air_m, radius_m - distance_m);
        else
            claim.liquid_m = std::min(claim.liquid_m, radius_m + distance_m);
    }
}

void SurfaceParticles::adjust_radii(const grid::BoxField& phi, core::ThreadPool& pool) {
    pool.run((positions_m_.size() + kBlock - 1) / kBlock, [&](std::size_t block, int) {
        const std::size_t end = std::min(positions_m_.size(), (block + 1) * kBlock);
        for (std::size_t p = block * kBlock; p < end; ++p)
            signed_radii_m_[p] =
                signed_radius_m(phi_at(phi, positions_m_[p]), signed_radii_m_[p] > 0.0F);
    });
}

void SurfaceParticles::sort_into_cells() {
    const std::size_t cells = static_cast<std::size_t>(shape_.nx) * static_cast<std::size_t>(shape_.ny) *
                              static_cast<std::size_t>(shape_.nz);
    std::vector<std::uint32_t> cell_of(positions_m_.size());
    cell_begin_.assign(cells + 1, 0);
    for (std::size_t p = 0; p < positions_m_.size(); ++p) {
        const glm::vec3& at = positions_m_[p];
        const int i = cell_along(at.x, shape_.cell_m, shape_.nx),
                  j = cell_along(at.y, shape_.cell_m, shape_.ny),
                  k = cell_along(at.z, shape_.cell_m, shape_.nz);
        cell_of[p] = static_cast<std::uint32_t>(i + shape_.nx * (j + shape_.ny * k));
        ++cell_begin_[cell_of[p] + 1];
    }
    for (std::size_t cell = 0; cell < cells; ++cell)
        cell_begin_[cell + 1] += cell_begin_[cell];
    order_.resize(positions_m_.size());
    std::vector<std::uint32_t> next(cell_begin_.begin(), cell_begin_.end() - 1);
    for (std::size_t p = 0; p < positions_m_.size(); ++p)
        order_[next[cell_of[p]]++] = static_cast<std::uint32_t>(p);
}

void SurfaceParticles::fill_up(const grid::BoxField& phi, int i, int j, int k, int count,
                               std::vector<Particle>& particles) const {
    const std::uint32_t stream = core::scramble(settings_.seed + generation_ * 0x9E3779B9U);
    const auto cell = static_cast<std::uint32_t>(i + shape_.nx * (j + shape_.ny * k));
    for (std::uint32_t n = 0; n < static_cast<std::uint32_t>(count); ++n) {
        const std::uint32_t index = 3U * (64U * cell + n);
        const glm::vec3 within(core::uniform_noise(index, stream),
                               core::uniform_noise(index + 1, stream),
                               core::uniform_noise(index + 2, stream));
        const glm::vec3 corner(static_cast<float>(i), static_cast<float>(j), static_cast<float>(k));
        const glm::vec3 at_m = (corner + within) * shape_.cell_m;
        const float phi_m = phi_at(phi, at_m);
        if (std::abs(phi_m) >= settings_.band_cells * shape_.cell_m) continue;
        particles.push_back({at_m, signed_radius_m(phi_m, phi_m >= 0.0F)});
    }
}

void SurfaceParticles::reseed_slice(const grid::BoxField& phi, int k,
                                    std::vector<Particle>& particles) const {
    const float band_m = settings_.band_cells * shape_.cell_m;
    for (int j = 0; j < shape_.ny; ++j)
        for (int i = 0; i < shape_.nx; ++i) {
            const auto cell = static_cast<std::size_t>(i + shape_.nx * (j + shape_.ny * k));
            int kept = 0;
            bool any_escaped = false;
            for (std::uint32_t n = cell_begin_[cell]; n < cell_begin_[cell + 1]; ++n) {
                const Particle particle = {positions_m_[order_[n]], signed_radii_m_[order_[n]]};
                const float phi_m = phi_at(phi, particle.position_m);
                const bool has_escaped = escaped(phi_m, particle.signed_radius_m);
                any_escaped = any_escaped || has_escaped;
                if (!has_escaped) {
                    if (std::abs(phi_m) >= band_m || 2 * kept >= 3 * settings_.per_cell) continue;
                    ++kept;
                }
                particles.push_back(particle);
            }
            if (!any_escaped && kept < settings_.per_cell && std::abs(phi.at(i, j, k)) < band_m)
                fill_up(phi, i, j, k, settings_.per_cell - kept, particles);
        }
}

void SurfaceParticles::reseed(const grid::BoxField& phi, core::ThreadPool& pool) {
    PASTOSO_CHECK(phi.shape() == shape_);
    ++generation_;
    sort_into_cells();
    std::vector<std::vector<Particle>> slices(static_cast<std::size_t>(shape_.nz));
    liquid::for_slices(pool, 0, shape_.nz,
                       [&](int k) { reseed_slice(phi, k, slices[static_cast<std::size_t>(k)]); });
    positions_m_.clear();
    signed_radii_m_.clear();
    for (const auto& slice : slices)
        for (const Particle& particle : slice) {
            positions_m_.push_back(particle.position_m);
            signed_radii_m_.push_back(particle.signed_radius_m);
        }
}

void SurfaceParticles::set_state(SurfaceParticleState state) {
    PASTOSO_CHECK_OP(state.positions_m.size(), ==, state.signed_radii_m.size());
    const glm::vec3 size_m = glm::vec3(shape_.nx, shape_.ny, shape_.nz) * shape_.cell_m;
    for (const glm::vec3& at_m : state.positions_m)
        for (const int axis : liquid::kAxes)
            if (!(at_m[axis] >= 0.0F && at_m[axis] <= size_m[axis]))
                throw core::InputError("A particle of this state is not within the tank.");
    generation_ = state.seedings;
    positions_m_ = std::move(state.positions_m);
    signed_radii_m_ = std::move(state.signed_radii_m);
}

void SurfaceParticles::remove_where(const std::function<bool(const glm::vec3&)>& gone) {
    std::size_t kept = 0;
    for (std::size_t p = 0; p < positions_m_.size(); ++p) {
        if (gone(positions_m_[p])) continue;
        positions_m_[kept] = positions_m_[p];
        signed_radii_m_[kept++] = signed_radii_m_[p];
    }
    positions_m_.resize(kept);
    signed_radii_m_.resize(kept);
}

}  // namespace pastoso::tank

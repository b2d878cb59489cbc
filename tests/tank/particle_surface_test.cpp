#include "tank/particle_surface.hpp"

#include "tank/sample_rows.hpp"
#include "tank_cases.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace pastoso::tank {
namespace {

const grid::BoxShape kBox = {16, 14, 18, 0.1F};

struct Found {
    grid::BoxField level_m{kBox, 1.0F}, excess{kBox};
};

Found find(std::vector<Particle> particles, core::ThreadPool& pool) {
    ParticleCells cells(kBox);
    cells.sort(particles, pool);
    const Domain domain(kBox, [](const glm::vec3&) { return 1.0F; });
    ParticleSurface surface(domain);
    Found found;
    const liquid::RowRanges rows = widened_cells(cells.rows(), kBox, 1);
    surface.compute(cells, rows, found.level_m, pool);
    surface.compute_excess(cells, rows, found.level_m, found.excess, pool);
    return found;
}

/// Eight particles in each cell below a height, anywhere within their octants.
std::vector<Particle> pool_of(float height_cells, int octants_along = 2) {
    std::vector<Particle> particles;
    std::uint32_t n = 0;
    const float side = 1.0F / static_cast<float>(octants_along);
    const auto number = [&] { return core::uniform_noise(n++, 3); };
    for (int k = 0; k < octants_along * kBox.nz; ++k)
        for (int j = 0; j < octants_along * kBox.ny; ++j)
            for (int i = 0; i < octants_along * kBox.nx; ++i) {
                const glm::vec3 at =
                    (glm::vec3(i, j, k) + glm::vec3(number(), number(), number())) * side;
                if (at.z < height_cells) particles.push_back({at * kBox.cell_m, 0.0F, {}});
            }
    return particles;
}

TEST(ParticleSurface, OneParticleIsABall) {
    core::ThreadPool pool(1);
    const Found found = find({{{0.52F, 0.61F, 0.77F}, 0.0F, {}}}, pool);
    for (int k = 0; k < kBox.nz; ++k)
        for (int j = 0; j < kBox.ny; ++j)
            for (int i = 0; i < kBox.nx; ++i) {
                const glm::vec3 middle_m = (glm::vec3(i, j, k) + 0.5F) * kBox.cell_m;
                const float way_m = glm::distance(middle_m, {0.52F, 0.61F, 0.77F});
                // Beyond the kernel's reach only that it is not near is known.
                if (way_m < 0.99F * kKernelReach_cells * kBox.cell_m &&
                    glm::abs(glm::ivec3(5, 6, 7) - glm::ivec3(i, j, k)) == glm::ivec3(0))
                    EXPECT_NEAR(found.level_m.at(i, j, k), way_m - kParticleRadius_cells * kBox.cell_m,
                                1e-6F);
                else
                    EXPECT_GT(found.level_m.at(i, j, k), 0.0F);
            }
}

/// Where the field crosses zero above a column, in cells.
float surface_height_cells(const grid::BoxField& level_m, int i, int j) {
    for (int k = 1; k < kBox.nz; ++k) {
        const float below = level_m.at(i, j, k - 1), above = level_m.at(i, j, k);
        if (below < 0.0F && above >= 0.0F) return static_cast<float>(k) - 0.5F + below / (below - above);
    }
    return 0.0F;
}

/// On average over the columns a half-space of particles ends where its surface is found.
TEST(ParticleSurface, AHalfSpaceEndsWhereItsParticlesDo) {
    core::ThreadPool pool(2);
    for (const float height_cells : {8.0F, 8.25F, 8.5F, 8.75F}) {
        const Found found = find(pool_of(height_cells), pool);
        float sum = 0.0F, least = 100.0F, most = 0.0F;
        for (int j = 2; j < kBox.ny - 2; ++j)
            for (int i = 2; i < kBox.nx - 2; ++i) {
                const float height = surface_height_cells(found.level_m, i, j);
                sum += height;
                least = std::min(least, height);
                most = std::max(most, height);
            }
        const float mean = sum / static_cast<float>((kBox.ny - 4) * (kBox.nx - 4));
        // Eight particles a cell at random: the layer that is seen ends a fraction of an octant early.
        EXPECT_NEAR(mean, height_cells, 0.2F);
        EXPECT_GT(least, height_cells - 0.6F);
        EXPECT_LT(most, height_cells + 0.4F);
    }
}

TEST(ParticleSurface, EvenlyFullCellsHaveNoExcessAndDoubleOnesAsMuchAgain) {
    core::ThreadPool pool(2);
    std::vector<Particle> particles = pool_of(9.0F);
    const Found full = find(particles, pool);
    const std::size_t count = particles.size();
    for (std::size_t p = 0; p < count; ++p)
        particles.push_back(particles[p]);
    const Found twice = find(particles, pool);
    for (int k = 1; k < 7; ++k)
        for (int j = 1; j < kBox.ny - 1; ++j)
            for (int i = 1; i < kBox.nx - 1; ++i) {
                ASSERT_EQ(full.excess.at(i, j, k), 0.0F);
                ASSERT_EQ(twice.excess.at(i, j, k), 1.0F);
            }
    EXPECT_EQ(full.excess.at(5, 5, 9), 0.0F);  // at the surface nothing is known
    EXPECT_EQ(twice.excess.at(5, 5, 9), 0.0F);
}

TEST(ParticleSurface, ForgetsWhereParticlesWere) {
    core::ThreadPool pool(1);
    std::vector<Particle> first = pool_of(9.0F), second = {{{0.15F, 0.15F, 1.65F}, 0.0F, {}}};
    ParticleCells cells(kBox);
    const Domain domain(kBox, [](const glm::vec3&) { return 1.0F; });
    ParticleSurface surface(domain);
    grid::BoxField level_m(kBox, 1.0F);
    cells.sort(first, pool);
    surface.compute(cells, widened_cells(cells.rows(), kBox, 1), level_m, pool);
    EXPECT_LT(level_m.at(8, 8, 2), 0.0F);
    cells.sort(second, pool);
    surface.compute(cells, widened_cells(cells.rows(), kBox, 1), level_m, pool);
    EXPECT_GT(level_m.at(8, 8, 2), 0.0F);
    EXPECT_LT(level_m.at(1, 1, 16), 0.0F);
}

TEST(ParticleSurface, IsTheSameOnAnyNumberOfThreads) {
    core::ThreadPool single(1), several(3);
    const std::vector<Particle> particles = cases::random_particles(kBox, 4000, 6);
    const Found one = find(particles, single), three = find(particles, several);
    EXPECT_EQ(one.level_m, three.level_m);
    EXPECT_EQ(one.excess, three.excess);
}

}  // namespace
}  // namespace pastoso::tank

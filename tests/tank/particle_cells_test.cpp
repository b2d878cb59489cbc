#include "tank/particle_cells.hpp"

#include "tank_cases.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace pastoso::tank {
namespace {

const grid::BoxShape kBox = {9, 7, 11, 0.1F};

glm::ivec3 cell_of(const Particle& particle) {
    return glm::ivec3(particle.position_m / kBox.cell_m);
}

TEST(ParticleCells, PutsParticlesIntoTheOrderOfTheirCells) {
    core::ThreadPool pool(2);
    std::vector<Particle> particles = cases::random_particles(kBox, 5000, 3);
    const std::vector<Particle> before = particles;
    ParticleCells cells(kBox);
    cells.sort(particles, pool);
    ASSERT_EQ(particles.size(), before.size());
    std::size_t seen = 0;
    for (int k = 0; k < kBox.nz; ++k)
        for (int j = 0; j < kBox.ny; ++j)
            for (int i = 0; i < kBox.nx; ++i) {
                ASSERT_EQ(cells.begin(i, j, k), seen);
                for (; seen < cells.end(i, j, k); ++seen)
                    ASSERT_EQ(cell_of(particles[seen]), glm::ivec3(i, j, k));
            }
    EXPECT_EQ(seen, particles.size());
    // Nobody is lost, and those of a cell keep their order.
    std::vector<Particle> expected = before;
    std::ranges::stable_sort(expected, {}, [](const Particle& particle) {
        const glm::ivec3 cell = cell_of(particle);
        return (cell.z * kBox.ny + cell.y) * kBox.nx + cell.x;
    });
    EXPECT_EQ(particles, expected);
}

TEST(ParticleCells, KnowsTheRowsThatHaveParticles) {
    core::ThreadPool pool(1);
    std::vector<Particle> particles = {{{0.25F, 0.35F, 0.45F}, 0.0F, {}},
                                       {{0.85F, 0.35F, 0.45F}, 0.0F, {}}};
    ParticleCells cells(kBox);
    cells.sort(particles, pool);
    for (int k = 0; k < kBox.nz; ++k)
        for (int j = 0; j < kBox.ny; ++j) {
            const bool here = j == 3 && k == 4;
            EXPECT_EQ(cells.rows().at(j, k), (here ? liquid::RowRange{2, 9} : liquid::RowRange{}));
        }
    EXPECT_EQ(cells.slice_begin(4), 0U);
    EXPECT_EQ(cells.slice_begin(5), 2U);
    // A second sort forgets the first.
    particles.pop_back();
    cells.sort(particles, pool);
    EXPECT_EQ(cells.rows().at(3, 4), (liquid::RowRange{2, 3}));
}

TEST(ParticleCells, AreTheSameOnAnyNumberOfThreads) {
    std::vector<Particle> one = cases::random_particles(kBox, 3000, 9), three = one;
    core::ThreadPool single(1), several(3);
    ParticleCells cells(kBox);
    cells.sort(one, single);
    cells.sort(three, several);
    EXPECT_EQ(one, three);
}

}  // namespace
}  // namespace pastoso::tank

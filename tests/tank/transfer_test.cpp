#include "tank/transfer.hpp"

#include "tank/sample_rows.hpp"
#include "tank_cases.hpp"

#include <gtest/gtest.h>

namespace pastoso::tank {
namespace {

const grid::BoxShape kBox = {12, 10, 14, 0.1F};

liquid::RowRanges everywhere() {
    liquid::RowRanges rows(kBox);
    for (int k = 0; k <= kBox.nz; ++k)
        for (int j = 0; j <= kBox.ny; ++j)
            rows.at(j, k) = {0, kBox.nx + 1};
    return rows;
}

struct Grid {
    liquid::VelocityField velocity{kBox}, weight{kBox};
};

Grid to_faces(std::vector<Particle>& particles, core::ThreadPool& pool) {
    ParticleCells cells(kBox);
    cells.sort(particles, pool);
    Transfer transfer(kBox);
    Grid grid;
    transfer.to_faces(particles, cells, everywhere(), grid.velocity, grid.weight, pool);
    return grid;
}

TEST(Transfer, OneParticleGivesTheEightFacesAroundItTrilinearWeights) {
    core::ThreadPool pool(1);
    // A quarter of a cell behind the face at x = 3, in the middle of cells along y and z.
    std::vector<Particle> particles = {{{0.325F, 0.45F, 0.55F}, 0.0F, {2.0F, -1.0F, 0.5F}}};
    const Grid grid = to_faces(particles, pool);
    EXPECT_NEAR(grid.weight.x.at(3, 4, 5), 0.75F, 1e-5F);
    EXPECT_NEAR(grid.weight.x.at(4, 4, 5), 0.25F, 1e-5F);
    EXPECT_NEAR(grid.weight.z.at(2, 4, 5), 0.125F, 1e-5F);
    EXPECT_NEAR(grid.weight.z.at(3, 4, 5), 0.375F, 1e-5F);
    EXPECT_NEAR(grid.weight.z.at(3, 4, 6), 0.375F, 1e-5F);
    EXPECT_EQ(grid.velocity.x.at(3, 4, 5), 2.0F);
    EXPECT_EQ(grid.velocity.z.at(3, 4, 6), 0.5F);
    EXPECT_EQ(grid.velocity.x.at(5, 4, 5), 0.0F);
    EXPECT_EQ(grid.weight.x.at(5, 4, 5), 0.0F);
}

TEST(Transfer, WeightsAndMomentumAreThoseOfTheParticles) {
    core::ThreadPool pool(2);
    std::vector<Particle> particles = cases::random_particles(kBox, 4000, 4);
    const Grid grid = to_faces(particles, pool);
    for (const int axis : liquid::kAxes) {
        double weight = 0.0, momentum = 0.0, expected = 0.0;
        for (std::size_t n = 0; n < grid.weight.x.values().size(); ++n) {
            const double w = static_cast<double>(grid.weight.along(axis).values()[n]);
            weight += w;
            momentum += w * static_cast<double>(grid.velocity.along(axis).values()[n]);
        }
        for (const Particle& particle : particles)
            expected += static_cast<double>(particle.velocity_m_s[axis]);
        // Sums of thousands of floats of about 1.
        EXPECT_NEAR(weight, 4000.0, 4000.0 * 1e-6);
        EXPECT_NEAR(momentum, expected, 4000.0 * 1e-6);
    }
}

/// What to_particles() makes of still particles in a velocity that is linear in x.
TEST(Transfer, ParticlesTakeALinearVelocityAndFollowIt) {
    core::ThreadPool pool(2);
    liquid::VelocityField old(kBox), now(kBox);
    for (int k = 0; k <= kBox.nz; ++k)
        for (int j = 0; j <= kBox.ny; ++j)
            for (int i = 0; i <= kBox.nx; ++i) {
                now.x.at(i, j, k) = 0.1F * static_cast<float>(i) * kBox.cell_m;
                now.y.at(i, j, k) = 0.3F;
            }
    std::vector<Particle> particles = {{{0.63F, 0.41F, 0.77F}, 0.5F, {0.0F, 0.0F, 0.2F}}};
    Transfer transfer(kBox);
    transfer.to_particles(old, now, everywhere(), {1.0F, 0.1F, 0.0F}, particles, pool);
    const Particle& moved = particles.front();
    // FLIP: what the grid has gained, on top of its own.
    EXPECT_NEAR(moved.velocity_m_s.x, 0.063F, 1e-6F);
    EXPECT_NEAR(moved.velocity_m_s.y, 0.3F, 1e-6F);
    EXPECT_NEAR(moved.velocity_m_s.z, 0.2F, 1e-6F);
    // Midpoint rule: x + dt k (x + dt/2 k x), with k = 0.1 / s.
    EXPECT_NEAR(moved.position_m.x, 0.63F + 0.1F * 0.1F * (0.63F + 0.05F * 0.063F), 1e-6F);
    EXPECT_NEAR(moved.position_m.y, 0.44F, 1e-6F);
    EXPECT_NEAR(moved.position_m.z, 0.77F, 1e-6F);  // now.z is 0: its own velocity does not move it
    EXPECT_EQ(moved.milk, 0.5F);
    transfer.to_particles(old, now, everywhere(), {0.0F, 0.0F, 0.0F}, particles, pool);
    EXPECT_NEAR(particles.front().velocity_m_s.z, 0.0F, 1e-6F);  // PIC: the grid's alone
}

TEST(Transfer, NothingRubsAlongWalls) {
    core::ThreadPool pool(1);
    liquid::VelocityField old(kBox), now(kBox);
    for (int k = 0; k < kBox.nz; ++k)
        for (int j = 0; j < kBox.ny; ++j)
            for (int i = 0; i <= kBox.nx; ++i)
                now.x.at(i, j, k) = 1.0F;
    std::vector<Particle> particles = {{{0.5F, 0.001F, 0.001F}, 0.0F, {}},
                                       {{0.5F, 0.999F, 1.399F}, 0.0F, {}}};
    Transfer transfer(kBox);
    transfer.to_particles(old, now, everywhere(), {0.97F, 0.01F, 0.0F}, particles, pool);
    for (const Particle& particle : particles)
        EXPECT_NEAR(particle.velocity_m_s.x, 1.0F, 1e-6F);
}

TEST(Transfer, KeepsParticlesInTheBox) {
    core::ThreadPool pool(1);
    liquid::VelocityField old(kBox), now(kBox);
    for (float& value : now.x.values())
        value = 100.0F;
    std::vector<Particle> particles = {{{1.1F, 0.5F, 0.5F}, 0.0F, {}}};
    Transfer transfer(kBox);
    transfer.to_particles(old, now, everywhere(), {0.97F, 0.1F, 0.0F}, particles, pool);
    EXPECT_LE(particles.front().position_m.x, 1.2F + 1e-6F);
}

TEST(Transfer, IsTheSameOnAnyNumberOfThreads) {
    core::ThreadPool single(1), several(3);
    std::vector<Particle> one = cases::random_particles(kBox, 6000, 8), three = one;
    const Grid a = to_faces(one, single), b = to_faces(three, several);
    EXPECT_EQ(a.velocity, b.velocity);
    EXPECT_EQ(a.weight, b.weight);
    Transfer transfer(kBox);
    transfer.to_particles(a.weight, a.velocity, everywhere(), {0.97F, 0.02F, 0.0F}, one, single);
    transfer.to_particles(a.weight, a.velocity, everywhere(), {0.97F, 0.02F, 0.0F}, three, several);
    EXPECT_EQ(one, three);
}

/// Mirrored along x, the faces' velocities are the mirrored ones: sums are taken in another order, so
/// that the last bits may differ.
TEST(Transfer, MirrorsWhatIsMirrored) {
    core::ThreadPool pool(2);
    std::vector<Particle> particles = cases::random_particles(kBox, 3000, 2), mirrored = particles;
    for (Particle& particle : mirrored) {
        particle.position_m.x = 1.2F - particle.position_m.x;
        particle.velocity_m_s.x = -particle.velocity_m_s.x;
    }
    const Grid a = to_faces(particles, pool), b = to_faces(mirrored, pool);
    for (int k = 0; k < kBox.nz; ++k)
        for (int j = 0; j < kBox.ny; ++j)
            for (int i = 0; i < kBox.nx; ++i) {
                // Where all weights are small, positions' last bits count for more.
                if (a.weight.x.at(i, j, k) < 0.05F || a.weight.y.at(i, j, k) < 0.05F) continue;
                ASSERT_NEAR(a.velocity.x.at(i, j, k), -b.velocity.x.at(kBox.nx - i, j, k), 2e-4F);
                ASSERT_NEAR(a.velocity.y.at(i, j, k), b.velocity.y.at(kBox.nx - 1 - i, j, k), 2e-4F);
            }
}

}  // namespace
}  // namespace pastoso::tank

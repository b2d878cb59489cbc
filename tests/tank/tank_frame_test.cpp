#include "tank/tank_frame.hpp"

#include "tank_cases.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::tank {
namespace {

const grid::BoxShape kBox = {16, 14, 18, 0.1F};

struct Sampled {
    liquid::SampledField level_m;
    grid::BoxField milk{kBox};
};
Sampled sampled(std::vector<Particle> particles, int parts, int threads = 2) {
    core::ThreadPool pool(threads);
    ParticleCells cells(kBox);
    cells.sort(particles, pool);
    const Domain domain(kBox, [](const glm::vec3&) { return 1.0F; });
    Sampled found{liquid::SampledField(frame_lattice(kBox, parts))};
    sample_particles(cells, domain, found.level_m, pool);
    average_milk(particles, cells, found.milk, pool);
    return found;
}

/// Eight particles in each cell between two heights, anywhere within their octants.
std::vector<Particle> layer(float low_cells, float high_cells) {
    std::vector<Particle> particles;
    std::uint32_t n = 0;
    const auto number = [&] { return core::uniform_noise(n++, 5); };
    for (int k = 0; k < 2 * kBox.nz; ++k)
        for (int j = 0; j < 2 * kBox.ny; ++j)
            for (int i = 0; i < 2 * kBox.nx; ++i) {
                const glm::vec3 at =
                    0.5F * (glm::vec3(i, j, k) + glm::vec3(number(), number(), number()));
                if (at.z >= low_cells && at.z < high_cells)
                    particles.push_back({at * kBox.cell_m, 0.25F, {}});
            }
    return particles;
}

/// Mean and standard deviation of the surface's height over the columns, in cells.
struct Heights {
    double mean, deviation;
};
Heights heights_of(const liquid::SampledField& level_m) {
    const liquid::Lattice& lattice = level_m.lattice();
    double sum = 0.0, squares = 0.0;
    int count = 0;
    for (int j = 0; j < lattice.ny; ++j)
        for (int i = 0; i < lattice.nx; ++i)
            for (int k = lattice.nz - 1; k > 0; --k) {
                const float below = level_m.at(i, j, k - 1), above = level_m.at(i, j, k);
                if (!(below < 0.0F && above >= 0.0F)) continue;
                const float share = below / (below - above);
                const double height =
                    static_cast<double>(lattice.point_m(i, j, k - 1).z + share * lattice.spacing_m) /
                    0.1;
                sum += height, squares += height * height, ++count;
                break;
            }
    const double mean = sum / count;
    EXPECT_EQ(count, lattice.nx * lattice.ny);
    return {mean, std::sqrt(squares / count - mean * mean)};
}

TEST(TankFrame, ASurfaceOfParticlesIsEvenAndWhereTheyEnd) {
    for (const int parts : {2, 3}) {
        const Heights heights = heights_of(sampled(layer(0.0F, 8.5F), parts).level_m);
        // Particles anywhere within their octants end a tenth of a cell early on average; as they are,
        // without smoothing, their surface has a deviation of 0.12 to 0.14.
        EXPECT_NEAR(heights.mean, 8.4, 0.15) << parts;
        EXPECT_LT(heights.deviation, 0.07) << parts;
    }
}

TEST(TankFrame, DropsAndThinSheetsStay) {
    const Sampled drop = sampled({{{0.775F, 0.625F, 0.875F}, 1.0F, {}}}, 2);
    // At a point of the lattice: the particle's radius less what smoothing may take.
    const glm::ivec3 at = glm::ivec3((glm::vec3(0.775F, 0.625F, 0.875F) + 0.075F) / 0.05F + 0.5F);
    EXPECT_LT(drop.level_m.at(at.x, at.y, at.z), -0.2F * kBox.cell_m);
    // Half a cell thick: nowhere a hole.
    const Sampled sheet = sampled(layer(8.0F, 8.5F), 2);
    heights_of(sheet.level_m);
}

TEST(TankFrame, MilkGoesOnBesideTheLiquid) {
    const Sampled found = sampled(layer(0.0F, 8.0F), 1);
    for (int k = 0; k < 10; ++k)
        EXPECT_NEAR(found.milk.at(5, 6, k), 0.25F, 1e-6F) << k;
    EXPECT_EQ(found.milk.at(5, 6, 10), 0.0F);
}

TEST(TankFrame, IsTheSameOnAnyNumberOfThreads) {
    const std::vector<Particle> particles = cases::random_particles(kBox, 4000, 6);
    const Sampled one = sampled(particles, 2, 1), three = sampled(particles, 2, 3);
    for (int k = 0; k < one.level_m.lattice().nz; ++k)
        for (int j = 0; j < one.level_m.lattice().ny; ++j)
            for (int i = 0; i < one.level_m.lattice().nx; ++i)
                ASSERT_EQ(one.level_m.at(i, j, k), three.level_m.at(i, j, k));
    EXPECT_EQ(one.milk, three.milk);
}

}  // namespace
}  // namespace pastoso::tank

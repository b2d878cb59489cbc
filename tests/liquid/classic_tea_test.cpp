#include "liquid/classic/classic_tea.hpp"

#include "core/error.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

PileUp after(double seconds, const ClassicSettings& settings) {
    core::ThreadPool pool(2);
    ClassicTea tea(settings);
    while (tea.time_s() < seconds)
        tea.step(pool);
    return pile_up(tea.particles_m(), 6, settings.box_m);
}

TEST(PileUp, PointsSpreadByChanceHaveNone) {
    ClassicSettings settings;
    settings.particles = 100'000;
    const PileUp found = pile_up(ClassicTea(settings).particles_m(), 6, settings.box_m);
    // Standard deviations: sqrt(0.2 * 0.8 / 300000) / 0.2 = 0.004 and sqrt(2 / 215) = 0.096.
    EXPECT_NEAR(found.at_borders, 1.0, 0.015);
    EXPECT_NEAR(found.dispersion, 1.0, 0.35);
}

TEST(PileUp, PointsOnALatticeAreAllAtItsBorders) {
    std::vector<glm::vec3> points_m;
    for (int i = 0; i < 6; ++i)
        points_m.emplace_back((static_cast<float>(i) + 0.5F) * 0.1F / 6.0F);
    EXPECT_DOUBLE_EQ(pile_up(points_m, 6, 0.1F).at_borders, 5.0);
}

TEST(PileUp, OneInEachVoxelIsNone) {
    std::vector<glm::vec3> points_m;
    for (int k = 0; k < 4; ++k)
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i)
                points_m.push_back(0.025F * glm::vec3(i, j, k));
    const PileUp found = pile_up(points_m, 4, 0.1F);
    EXPECT_EQ(found.dispersion, 0.0);
    EXPECT_EQ(found.at_borders, 0.0);
}

TEST(ClassicTea, ParticlesPileUpOnTheSourcesLatticeAndNotInTheProduct) {
    ClassicSettings settings;
    settings.particles = 4000;
    const PileUp source = after(2.0, settings);
    settings.solver = ClassicSolver::Product;
    settings.cells = 32;
    const PileUp product = after(2.0, settings);
    // A mean of 18.5 particles a voxel; chance alone gives 1, give or take 0.1.
    EXPECT_GT(source.dispersion, 10.0);
    EXPECT_LT(product.dispersion, 1.4);
    EXPECT_NEAR(product.at_borders, 1.0, 0.1);
}

TEST(ClassicTea, AShearDecaysAsTheSevenPointLaplacianSays) {
    core::ThreadPool pool(1);
    const int cells = 12;
    const grid::BoxShape shape{cells, cells, cells, 0.1F / cells};
    SourceLattice flow(shape);
    const auto wave = [&](int j) { return std::sin(2.0 * std::numbers::pi * (j + 0.5) / cells); };
    for (int k = 0; k < cells; ++k)
        for (int j = 0; j < cells; ++j)
            for (int i = 0; i < cells; ++i)
                flow.along(0).at(i, j, k) = static_cast<float>(1e-3 * wave(j));
    const double nu = 1e-4, dt = 0.05, h = 0.1 / cells;
    const double laplace = (2.0 - 2.0 * std::cos(2.0 * std::numbers::pi / cells)) / (h * h);
    for (int step = 0; step < 10; ++step)
        flow.step(static_cast<float>(dt), static_cast<float>(nu), pool);
    const double left = std::pow(1.0 + nu * dt * laplace, -10);
    for (int j = 0; j < cells; ++j)
        // Floats, ten times there and back.
        EXPECT_NEAR(static_cast<double>(flow.along(0).at(3, j, 5)), 1e-3 * left * wave(j), 1e-8);
}

TEST(ClassicTea, TheSameBitsOnAnyNumberOfThreads) {
    const auto particles_with = [](int threads, ClassicSolver solver) {
        core::ThreadPool pool(threads);
        ClassicSettings settings;
        settings.solver = solver;
        settings.cells = 16;
        ClassicTea tea(settings);
        for (int step = 0; step < 20; ++step)
            tea.step(pool);
        return tea.particles_m();
    };
    for (const ClassicSolver solver : {ClassicSolver::Source, ClassicSolver::Product})
        EXPECT_EQ(particles_with(1, solver), particles_with(3, solver));
}

TEST(ClassicTea, BadNumbersAreRefused) {
    ClassicSettings settings;
    settings.cells = 0;
    EXPECT_THROW(ClassicTea{settings}, core::InputError);
    settings = {};
    settings.viscosity_m2_s = -1.0F;
    EXPECT_THROW(ClassicTea{settings}, core::InputError);
    settings = {};
    settings.swirl_rad_s2 = NAN;
    EXPECT_THROW(ClassicTea{settings}, core::InputError);
}

}  // namespace
}  // namespace pastoso::liquid

// A surface that a flow carries, as a level set alone, and the volume inside one.
#include "tank/level_set.hpp"

#include "tank/level_cases.hpp"
#include "tank/liquid_volume.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace pastoso::tank {
namespace {

using cases::Flow;
using cases::Followed;
using cases::sampled;
using cases::unit_box;

constexpr double kPi = std::numbers::pi;

double volume_of(const grid::BoxField& phi) {
    core::ThreadPool pool(2);
    return liquid_volume_m3(phi, pool);
}

TEST(LiquidVolume, IsExactWherePhiIsLinear) {
    const grid::BoxShape shape{6, 5, 4, 0.5F};
    // 3 x 2.5 x 2 metres.
    const auto below = [&](const glm::vec3& normal, float level) {
        return volume_of(
            sampled(shape, [=](const glm::vec3& p) { return glm::dot(p, normal) - level; }));
    };
    EXPECT_NEAR(below({0.0F, 0.0F, 1.0F}, 0.7F), 3.0 * 2.5 * 0.7, 1e-5);
    EXPECT_NEAR(below({1.0F, 0.0F, 0.0F}, 0.1F), 0.1 * 2.5 * 2.0, 1e-5);
    // A corner cut off: sides 0.9, 0.45, 0.3.
    EXPECT_NEAR(below({1.0F, 2.0F, 3.0F}, 0.9F), 0.9 * 0.45 * 0.3 / 6.0, 1e-6);
    EXPECT_NEAR(below({-1.0F, -2.0F, 3.0F}, -7.1F), 0.9 * 0.45 * 0.3 / 6.0, 1e-5);
    EXPECT_EQ(below({0.0F, 0.0F, 1.0F}, 9.0F), 15.0);
    EXPECT_EQ(below({0.0F, 0.0F, 1.0F}, -9.0F), 0.0);
}

TEST(LiquidVolume, OfABallIsOfSecondOrder) {
    const double exact = 4.0 / 3.0 * kPi * 0.3 * 0.3 * 0.3;
    const auto error = [&](int cells) {
        return volume_of(sampled(unit_box(cells), cases::sphere({0.51F, 0.47F, 0.5F}, 0.3F))) / exact -
               1.0;
    };
    const double coarse = error(16), fine = error(32);
    // Chords of balls of 4.8 and 9.6 cells: 2.2 and 0.54 % are lost.
    EXPECT_LT(std::abs(coarse), 0.025);
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.3);
}

TEST(LiquidVolume, OfTheLiquidAndOfTheAirMakeTheBox) {
    grid::BoxField phi = sampled(unit_box(16), [](const glm::vec3& p) {
        return std::sin(11.0F * p.x + 1.0F) * std::cos(9.0F * p.y) + std::sin(7.0F * p.z);
    });
    const double liquid = volume_of(phi);
    for (float& value : phi.values())
        value = -value;
    EXPECT_NEAR(liquid + volume_of(phi), 1.0, 1e-6);
    EXPECT_GT(liquid, 0.2);
}

TEST(LevelSet, GoesOnStraightBeyondWalls) {
    const auto value = [](const glm::vec3& p) { return 0.2F + p.x - 2.0F * p.y + 0.5F * p.z; };
    const grid::BoxField exact = sampled({6, 5, 4, 1.0F}, value);
    grid::BoxField phi({6, 5, 4, 1.0F}, 99.0F);
    for (int k = 0; k < 4; ++k)
        for (int j = 0; j < 5; ++j)
            std::copy_n(exact.row(j, k), 6, phi.row(j, k));
    continue_beyond_walls(phi);
    for (int k = -2; k < 6; ++k)
        for (int j = -2; j < 7; ++j)
            for (int i = -2; i < 8; ++i)
                ASSERT_NEAR(phi.at(i, j, k), exact.at(i, j, k), 1e-5F);
}

TEST(LevelSet, TheRowsOfABandHoldWhatIsNearTheSurface) {
    core::ThreadPool pool(2);
    const grid::BoxField phi = sampled(
        {16, 8, 8, 1.0F}, [](const glm::vec3& p) { return std::clamp(p.x + p.z - 10.0F, -2.0F, 2.0F); });
    const liquid::RowRanges rows = band_rows(phi, 2.0F, pool);
    // x + z within 8 to 12 at middles.
    EXPECT_EQ(rows.at(3, 0), (liquid::RowRange{8, 11}));
    EXPECT_EQ(rows.at(3, 7), (liquid::RowRange{1, 4}));
}

/// A sphere that a uniform flow has carried for some steps of a whole cell.
grid::BoxField carried_by_cells(const glm::vec3& velocity_m_s, int steps, LevelSetScheme scheme,
                                float reach_cells, int threads = 2) {
    core::ThreadPool pool(threads);
    const grid::BoxShape shape = unit_box(32);
    grid::BoxField phi = sampled(shape, cases::sphere(glm::vec3(0.5F), 0.2F));
    liquid::VelocityField velocity(shape);
    for (const int axis : liquid::kAxes)
        velocity.along(axis) = grid::BoxField(shape, velocity_m_s[axis]);
    LevelSetAdvection advection(shape);
    for (int step = 0; step < steps; ++step)
        advection.advect(phi, velocity, 1.0F / 32.0F, reach_cells, scheme, pool);
    return phi;
}

TEST(LevelSet, AUniformFlowShiftsItExactlyByWholeCells) {
    const grid::BoxField before = sampled(unit_box(32), cases::sphere(glm::vec3(0.5F), 0.2F));
    const grid::BoxField after =
        carried_by_cells({1.0F, -1.0F, 1.0F}, 3, LevelSetScheme::SemiLagrangian, 100.0F);
    // The first-order scheme is exact along an axis alone; rounding of three steps.
    const grid::BoxField upwind =
        carried_by_cells({0.0F, -1.0F, 0.0F}, 3, LevelSetScheme::Upwind, 100.0F);
    for (int k = 4; k < 28; ++k)
        for (int j = 4; j < 28; ++j)
            for (int i = 4; i < 28; ++i) {
                ASSERT_EQ(after.at(i, j, k), before.at(i - 3, j + 3, k - 3));
                ASSERT_NEAR(upwind.at(i, j, k), before.at(i, j + 3, k), 3e-7F);
            }
}

TEST(LevelSet, InABandTheSurfaceMovesAsInTheWholeBox) {
    // One step: cells next to the surface see no cell beyond the band.
    const grid::BoxField whole =
        carried_by_cells({0.5F, 0.3F, -0.4F}, 1, LevelSetScheme::SemiLagrangian, 100.0F);
    const grid::BoxField band =
        carried_by_cells({0.5F, 0.3F, -0.4F}, 1, LevelSetScheme::SemiLagrangian, 5.0F);
    int near = 0;
    for (int k = 0; k < 32; ++k)
        for (int j = 0; j < 32; ++j)
            for (int i = 0; i < 32; ++i)
                if (std::abs(whole.at(i, j, k)) < 2.0F / 32.0F) {
                    ++near;
                    ASSERT_EQ(band.at(i, j, k), whole.at(i, j, k));
                }
    EXPECT_GT(near, 1000);
}

TEST(LevelSet, TheFirstOrderSchemeTakesStepsInParts) {
    // The components add up to 2.4 cells a step: in one part it would blow up, in three no value leaves
    // the range of those around it.
    const grid::BoxField before = sampled(unit_box(32), cases::sphere(glm::vec3(0.5F), 0.2F));
    const grid::BoxField after =
        carried_by_cells({0.8F, 0.8F, -0.8F}, 6, LevelSetScheme::Upwind, 100.0F);
    float least = 1.0F, least_before = 1.0F;
    for (int k = 2; k < 30; ++k)
        for (int j = 2; j < 30; ++j)
            for (int i = 2; i < 30; ++i) {
                least = std::min(least, after.at(i, j, k));
                least_before = std::min(least_before, before.at(i, j, k));
            }
    EXPECT_GE(least, least_before);
    EXPECT_LT(least, 0.5F * least_before);
}

TEST(LevelSet, ATurnKeepsASphere) {
    core::ThreadPool pool(2);
    const Followed turned =
        cases::follow(Flow::Rotation, 48, {.kept_within_cells = kKeptWithin_cells}, pool);
    // Measured: 0.05 % and 0.013; a sphere of seven cells, 168 steps, 33 reinitialisations.
    EXPECT_LT(std::abs(turned.volume_error), 0.003);
    EXPECT_LT(turned.shape_error, 0.02);
}

TEST(LevelSet, NeedsTheLiquidsVelocityAlone) {
    // The air's is 1 km/s before it is continued from the liquid: none of it may get through.
    core::ThreadPool pool(2);
    const Followed stirred = cases::follow(Flow::Tank, 48, {}, pool);
    // Measured: 0.04 % and 0.0036, with 21 reinitialisations; the limited cubic with all of the air
    // continued 0.06 % and 0.0030.
    EXPECT_LT(std::abs(stirred.volume_error), 2e-3);
    EXPECT_LT(stirred.shape_error, 0.008);
    const Followed upwind =
        cases::follow(Flow::Tank, 32, {.scheme = LevelSetScheme::Upwind, .courant = 0.5}, pool);
    // Measured: 1.4 %.
    EXPECT_LT(std::abs(upwind.volume_error), 0.03);
}

TEST(LevelSet, LosesLittleOfASheetThinnerThanCells) {
    core::ThreadPool pool(2);
    const Followed pulled =
        cases::follow(Flow::Enright, 48, {.kept_within_cells = kKeptWithin_cells}, pool);
    // Measured: -9 % and 0.45; the limited cubic without reinitialisation loses 36 % here.
    EXPECT_LT(std::abs(pulled.volume_error), 0.15);
    EXPECT_LT(pulled.shape_error, 0.5);
}

TEST(LevelSet, TheFirstOrderSchemeLosesASphereInATurn) {
    // What the particles and the better scheme are for.
    core::ThreadPool pool(2);
    const Followed turned = cases::follow(Flow::Rotation, 32, {.scheme = LevelSetScheme::Upwind}, pool);
    EXPECT_LT(turned.volume_error, -0.5);
}

TEST(LevelSet, GivesTheSameBitsOnAnyNumberOfThreads) {
    for (const LevelSetScheme scheme : {LevelSetScheme::Upwind, LevelSetScheme::SemiLagrangian}) {
        const grid::BoxField one = carried_by_cells({0.5F, 0.3F, -0.4F}, 3, scheme, 5.0F, 1);
        for (const int threads : {2, 3})
            EXPECT_TRUE(carried_by_cells({0.5F, 0.3F, -0.4F}, 3, scheme, 5.0F, threads) == one);
    }
}

}  // namespace
}  // namespace pastoso::tank

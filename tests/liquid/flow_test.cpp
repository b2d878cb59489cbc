// The stages of a step in walled vessels.
#include "liquid/flow/flow.hpp"

#include "core/error.hpp"
#include "liquid/flow/confinement.hpp"
#include "liquid/flow_cases.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Walls, OpenTheirFacesByTheShareInTheFluid) {
    // A floor at 1.3 cells: the face at height 1 is shut, the one at 2 open, those beside cell 1 to 0.7.
    const grid::BoxShape shape{4, 4, 4, 0.5F};
    const Walls walls(shape, [](const glm::vec3& p) { return 0.65F - p.z; });
    EXPECT_NEAR(walls.open().z.at(1, 1, 1), 0.2F, 1e-6F);
    EXPECT_EQ(walls.open().z.at(1, 1, 2), 1.0F);
    EXPECT_NEAR(walls.open().x.at(2, 1, 1), 0.7F, 1e-6F);
    EXPECT_EQ(walls.open().x.at(2, 1, 0), 0.0F);
    EXPECT_EQ(walls.open().x.at(0, 1, 2), 0.0F);
    EXPECT_EQ(walls.open().z.at(1, 1, 4), 0.0F);
    EXPECT_EQ(walls.rows(Location::FaceX).at(1, 1), (RowRange{1, 4}));
    EXPECT_TRUE(walls.rows(Location::FaceX).at(1, 0).empty());
}

TEST(Walls, ContinueValuesAsMeansOfTheirNeighbours) {
    core::ThreadPool pool(2);
    const Walls walls({8, 8, 8, 1.0F}, [](const glm::vec3& p) { return 4.6F - p.x; });
    grid::BoxField field(walls.shape(), -9.0F);
    for (int k = 0; k < 8; ++k)
        for (int j = 0; j < 8; ++j)
            for (int i = 4; i < 8; ++i)
                field.at(i, j, k) = static_cast<float>(j);
    walls.extrapolate(field, Location::Cell, pool);
    for (const int i : {1, 2, 3})
        EXPECT_EQ(field.at(i, 4, 4), 4.0F);
    EXPECT_EQ(field.at(0, 4, 4), -9.0F);
    EXPECT_EQ(field.at(8, 4, 4), 4.0F);
}

TEST(VesselFlow, FluidAtRestStaysAtRestUnderGravity) {
    core::ThreadPool pool(2);
    constexpr float kFall = 9.81F / 30.0F;
    FlowParameters parameters;
    parameters.pressure.tolerance = 1e-6F;
    VesselFlow flow(cases::cup_box(64), cases::cup_distance(), parameters);
    flow.velocity().z = grid::BoxField(flow.shape(), -kFall);
    flow.project(pool);
    float fastest = 0.0F;
    for (const int axis : kAxes)
        for (int k = 0; k < 64; ++k)
            for (int j = 0; j < 64; ++j)
                for (int i = 0; i < 64; ++i)
                    if (flow.walls().open().along(axis).at(i, j, k) > 0.0F)
                        fastest = std::max(fastest, std::abs(flow.velocity().along(axis).at(i, j, k)));
    // The specification's bound; what is left is single precision against the column's pressure.
    EXPECT_LT(fastest, 5e-4F * kFall);
}

/// The growth rate of the unstable mode cos(2 pi x) sin(pi z) of a linear stratification with N = 1 per
/// second, buoyancy by halves around the rest of the step (Strang).
double growth_rate(int cells) {
    core::ThreadPool pool(2);
    constexpr float kStep_s = 0.05F, kStart = 1e-5F;
    FlowParameters parameters;
    parameters.viscosity_m2_s = 0.0F;
    parameters.pressure.tolerance = 1e-6F;
    VesselFlow flow({cells, 4, cells, 1.0F / static_cast<float>(cells)}, cases::no_walls, parameters);
    grid::BoxField light(flow.shape());
    const auto mode = [&](double i, double k) {
        return std::cos(2.0 * kPi * i / cells) * std::sin(kPi * k / cells);
    };
    const double rate = 2.0 / std::sqrt(5.0);
    for (int k = 0; k < cells; ++k)
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < cells; ++i) {
                light.at(i, j, k) = kStart * static_cast<float>(mode(i + 0.5, k + 0.5));
                // Of the vertical velocity the pressure leaves the share kx^2 / k^2 = 4/5.
                flow.velocity().z.at(i, j, k) =
                    kStart * static_cast<float>(1.25 * rate * mode(i + 0.5, k));
            }
    flow.project(pool);
    const auto rise = [&](float dt_s) {
        for (int k = 1; k < cells; ++k)
            for (int j = 0; j < 4; ++j)
                for (int i = 0; i < cells; ++i)
                    flow.velocity().z.at(i, j, k) +=
                        dt_s * 0.5F * (light.at(i, j, k) + light.at(i, j, k - 1));
    };
    // Nothing goes through the floor and the lid, whatever is continued there.
    const auto through = [&](int i, int j, int k) {
        return k > 0 && k < cells ? flow.velocity().z.at(i, j, k) : 0.0F;
    };
    const auto amplitude = [&] {
        double sum = 0.0;
        for (int k = 0; k < cells; ++k)
            for (int i = 0; i < cells; ++i)
                sum += static_cast<double>(light.at(i, 1, k)) * mode(i + 0.5, k + 0.5);
        return sum;
    };
    constexpr int kSteps = 40;
    const double first = amplitude();
    for (int step = 0; step < kSteps; ++step) {
        rise(0.5F * kStep_s);
        flow.project(pool);
        flow.advect_cells(std::array{&light}, kStep_s, KeepSum::No, pool);
        for (int k = 0; k < cells; ++k)
            for (int j = 0; j < 4; ++j)
                for (int i = 0; i < cells; ++i)
                    light.at(i, j, k) += kStep_s * 0.5F * (through(i, j, k) + through(i, j, k + 1));
        flow.advect_velocity(kStep_s, pool);
        rise(0.5F * kStep_s);
    }
    return std::log(amplitude() / first) / (kSteps * static_cast<double>(kStep_s));
}

TEST(VesselFlow, AnUnstableStratificationGrowsAtItsRate) {
    const double exact = 2.0 / std::sqrt(5.0);
    EXPECT_NEAR(growth_rate(32), exact, 0.01 * exact);
    EXPECT_NEAR(growth_rate(64), exact, 0.01 * exact);
}

/// A few steps of a flow that a cold lump drives, with everything switched on.
struct Stirred {
    VelocityField velocity;
    grid::BoxField coldness;
    std::vector<glm::vec3> points;
};
Stirred stir(int threads, const Kernels& kernels, bool mirrored = false) {
    core::ThreadPool pool(threads);
    constexpr float kStep_s = 1.0F / 30.0F;
    constexpr int kCells = 32;
    FlowParameters parameters;
    parameters.confinement = 0.2F;
    parameters.viscosity_m2_s = 1e-5F;
    parameters.velocity_advection = VelocityAdvection::Reflected;
    parameters.pressure.tolerance = 1e-5F;
    VesselFlow flow(cases::cup_box(kCells), cases::cup_distance(), parameters, kernels);
    Stirred stirred{{}, grid::BoxField(flow.shape()), {{mirrored ? 0.06F : 0.04F, 0.05F, 0.05F}}};
    for (int k = 14; k < 22; ++k)
        for (int j = 12; j < 19; ++j)
            for (int i = 10; i < 15; ++i)
                stirred.coldness.at(mirrored ? kCells - 1 - i : i, j, k) = 1.0F;
    for (int step = 0; step < 5; ++step) {
        for (int k = 1; k < kCells; ++k)
            for (int j = 0; j < kCells; ++j)
                for (int i = 0; i < kCells; ++i)
                    flow.velocity().z.at(i, j, k) -=
                        kStep_s * 0.3F *
                        (stirred.coldness.at(i, j, k) + stirred.coldness.at(i, j, k - 1));
        flow.confine_vorticity(kStep_s, pool);
        flow.diffuse_velocity(kStep_s, pool);
        flow.project(pool);
        flow.diffuse_cells(stirred.coldness, 2e-4F, kStep_s, pool);
        flow.advect_cells(std::array{&stirred.coldness}, kStep_s, KeepSum::Yes, pool);
        flow.carry(stirred.points, kStep_s, pool);
        flow.advect_velocity(kStep_s, pool);
    }
    flow.project(pool);
    stirred.velocity = flow.velocity();
    return stirred;
}

TEST(VesselFlow, GivesTheSameBitsOnAnyNumberOfThreadsAndEveryInstructionSet) {
    const Stirred one = stir(1, core::kernels<Kernels>(core::Isa::Baseline));
    const auto expect_same = [&](const Stirred& other) {
        EXPECT_TRUE(other.velocity == one.velocity);
        EXPECT_TRUE(other.coldness == one.coldness);
        EXPECT_EQ(other.points, one.points);
    };
    for (const int threads : {2, 3})
        expect_same(stir(threads, core::kernels<Kernels>()));
    for (const core::Isa isa : {core::Isa::Avx2, core::Isa::Avx512})
        if (isa <= core::best_isa()) expect_same(stir(1, core::kernels<Kernels>(isa)));
}

TEST(VesselFlow, AMirroredLumpMakesTheMirroredFlow) {
    const Stirred left = stir(1, core::kernels<Kernels>()),
                  right = stir(1, core::kernels<Kernels>(), true);
    float fastest = 0.0F, difference = 0.0F;
    for (int k = 2; k < 28; ++k)
        for (int j = 8; j < 24; ++j)
            for (int i = 8; i < 24; ++i) {
                fastest = std::max(fastest, std::abs(left.velocity.z.at(i, j, k)));
                difference =
                    std::max({difference,
                              std::abs(left.velocity.x.at(i, j, k) + right.velocity.x.at(32 - i, j, k)),
                              std::abs(left.velocity.z.at(i, j, k) - right.velocity.z.at(31 - i, j, k)),
                              std::abs(left.coldness.at(i, j, k) - right.coldness.at(31 - i, j, k))});
            }
    EXPECT_GT(fastest, 0.01F);
    // The pressure's sweeps begin with the other colour in the mirror image: its tolerance is 1e-5.
    EXPECT_LT(difference, 2e-4F);
    EXPECT_NEAR(left.points[0].x, 0.1F - right.points[0].x, 1e-6F);
}

TEST(VesselFlow, KeepsTheSumOfWhatItCarries) {
    core::ThreadPool pool(2);
    VesselFlow flow(cases::cup_box(32), cases::cup_distance());
    flow.velocity() = cases::random_velocity(flow.shape(), 3);
    for (const int axis : kAxes)
        for (float& value : flow.velocity().along(axis).values())
            value *= 0.1F;
    flow.project(pool);
    grid::BoxField milk(flow.shape());
    for (int k = 10; k < 20; ++k)
        for (int j = 12; j < 20; ++j)
            for (int i = 12; i < 20; ++i)
                milk.at(i, j, k) = 0.8F;
    const double before = flow.sum_over_cells(milk, pool);
    for (int step = 0; step < 10; ++step)
        flow.advect_cells(std::array{&milk}, 0.02F, KeepSum::Yes, pool);
    // Factors and values are rounded to 6e-8 each time.
    EXPECT_NEAR(flow.sum_over_cells(milk, pool), before, 2e-6 * before);
}

TEST(Diffusion, KeepsTheSumInACupAllWays) {
    core::ThreadPool pool(2);
    const Walls walls(cases::cup_box(32), cases::cup_distance());
    const auto sum = [&](const grid::BoxField& field) {
        double total = 0.0;
        for (int k = 0; k < 32; ++k)
            for (int j = 0; j < 32; ++j)
                for (int i = 0; i < 32; ++i)
                    total += static_cast<double>(walls.open_cells().at(i, j, k) * field.at(i, j, k));
        return total;
    };
    // 0.1, 1.4, 2 and 6.8 cells^2 a step: explicit, four and five stages, implicit.
    for (const float diffusivity : {3e-5F, 4e-4F, 6e-4F, 2e-3F}) {
        Diffusion diffusion(walls, Location::Cell, WallFriction::Slips);
        grid::BoxField milk(walls.shape());
        cases::fill_randomly(milk, 3);
        const double before = sum(milk);
        float largest_before = 1.0F, largest = 0.0F;
        for (int step = 0; step < 10; ++step)
            EXPECT_TRUE(
                diffusion.diffuse(walls, milk, diffusivity, 1.0F / 30.0F, {1e-6F, 50}, pool).converged);
        for (int k = 0; k < 32; ++k)
            for (int j = 0; j < 32; ++j)
                for (int i = 0; i < 32; ++i)
                    largest = std::max(largest, walls.open_cells().at(i, j, k) * milk.at(i, j, k));
        // Rounding of 12,000 values of size 1, or the implicit solution's tolerance.
        EXPECT_NEAR(sum(milk), before, 2e-2);
        EXPECT_LT(largest, largest_before);
    }
}

/// How much of a wave across a slit is left, against the exact decay.
double slit_decay(WallFriction friction, float viscosity_m2_s, int steps) {
    core::ThreadPool pool(2);
    constexpr int kCells = 32;
    // Side walls at the box's own: components along x, varying along z.
    const Walls walls({kCells, 4, kCells, 1.0F / kCells}, cases::no_walls);
    Diffusion diffusion(walls, Location::FaceX, friction);
    grid::BoxField u(walls.shape());
    // Samples at rest lie half a cell outside, free ones mirror at the wall.
    const auto wave = [&](int k) {
        return friction == WallFriction::Sticks ? std::sin(kPi * (k + 1.0) / (kCells + 1.0))
                                                : std::cos(kPi * (k + 0.5) / kCells);
    };
    for (int k = 0; k < kCells; ++k)
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i <= kCells; ++i)
                u.at(i, j, k) = static_cast<float>(wave(k));
    const float dt_s = 0.02F;
    for (int step = 0; step < steps; ++step)
        diffusion.diffuse(walls, u, viscosity_m2_s, dt_s, {1e-6F, 50}, pool);
    return static_cast<double>(u.at(kCells / 2, 2, 4)) / wave(4);
}

TEST(Diffusion, AWaveAcrossASlitThatSlipsDecaysAtItsRate) {
    // 0.1 cells^2 a step: explicit, first order in time.
    const double slow = 0.1 / (32.0 * 32.0 * 0.02);
    EXPECT_NEAR(slit_decay(WallFriction::Slips, static_cast<float>(slow), 100),
                std::exp(-kPi * kPi * slow * 2.0), 2e-3);
    // 1 and 2 cells^2 a step: Legendre's polynomials of degree four and five.
    const auto stages = [](unsigned degree, double step) {
        return std::legendre(
            degree, 1.0 - 2.0 / (degree * (degree + 1.0)) * step * (2.0 - 2.0 * std::cos(kPi / 32.0)));
    };
    for (const auto& [degree, step] : {std::pair(4U, 1.0), std::pair(5U, 2.0)})
        EXPECT_NEAR(slit_decay(WallFriction::Slips, static_cast<float>(10.0 * step * slow), 20),
                    std::pow(stages(degree, step), 20), 1e-4);
    // 5 cells^2 a step: implicit, backward Euler's exact factor.
    const double fast = 50.0 * slow, factor = 1.0 / (1.0 + 5.0 * (2.0 - 2.0 * std::cos(kPi / 32.0)));
    EXPECT_NEAR(slit_decay(WallFriction::Slips, static_cast<float>(fast), 20), std::pow(factor, 20),
                1e-4);
}

TEST(Diffusion, FluidSticksToTheWallWhereAsked) {
    // The faces beside the side walls are held by them as well: far from those, in the middle, nothing
    // yet.
    const double slow = 0.1 / (32.0 * 32.0 * 0.02);
    EXPECT_LT(slit_decay(WallFriction::Sticks, static_cast<float>(slow), 20),
              slit_decay(WallFriction::Slips, 0.0F, 20) - 1e-3);
}

TEST(Confinement, StrengthensASwirlAndLeavesAUniformFlow) {
    core::ThreadPool pool(2);
    const Walls walls({24, 24, 8, 1.0F}, cases::no_walls);
    VelocityField swirl(walls.shape());
    const auto speed = [](float x, float y) { return std::exp(-(x * x + y * y) / 18.0F); };
    for (int k = -2; k <= 10; ++k)
        for (int j = -2; j <= 26; ++j)
            for (int i = -2; i <= 26; ++i) {
                const float x = static_cast<float>(i) - 12.0F, y = static_cast<float>(j) - 12.0F;
                swirl.x.at(i, j, k) = -(y + 0.5F) * speed(x, y + 0.5F);
                swirl.y.at(i, j, k) = (x + 0.5F) * speed(x + 0.5F, y);
            }
    const VelocityField before = swirl;
    add_confinement(walls, 0.3F, 0.1F, swirl, pool);
    // Around the middle the force drives along the swirl.
    EXPECT_GT(swirl.y.at(14, 12, 4), before.y.at(14, 12, 4));
    EXPECT_LT(swirl.y.at(9, 12, 4), before.y.at(9, 12, 4));
    EXPECT_LT(swirl.y.at(14, 12, 4), 1.1F * before.y.at(14, 12, 4));
    VelocityField uniform(walls.shape());
    uniform.x = grid::BoxField(walls.shape(), 2.0F);
    const VelocityField same = uniform;
    add_confinement(walls, 0.3F, 0.1F, uniform, pool);
    EXPECT_TRUE(uniform == same);
}

TEST(VesselFlow, RefusesWhatMeansNothing) {
    const auto make = [](const grid::BoxShape& shape, const FlowParameters& parameters = {}) {
        VesselFlow flow(shape, cases::no_walls, parameters);
    };
    EXPECT_THROW(make({0, 8, 8, 1.0F}), core::InputError);
    EXPECT_THROW(make({4096, 4096, 4096, 1.0F}), core::InputError);
    EXPECT_THROW(make({8, 8, 8, 0.0F}), core::InputError);
    EXPECT_THROW(make({8, 8, 8, 1.0F}, {.viscosity_m2_s = -1e-6F}), core::InputError);
    EXPECT_THROW(make({8, 8, 8, 1.0F}, {.viscosity_m2_s = std::nanf("")}), core::InputError);
    EXPECT_THROW(make({8, 8, 8, 1.0F}, {.confinement = 0.4F}), core::InputError);
    EXPECT_THROW(VesselFlow({8, 8, 8, 1.0F}, [](const glm::vec3&) { return std::nanf(""); }),
                 core::InputError);
    core::ThreadPool pool(1);
    VesselFlow flow({8, 8, 8, 1.0F}, cases::no_walls);
    grid::BoxField field(flow.shape());
    EXPECT_THROW(flow.diffuse_cells(field, -1.0F, 0.1F, pool), core::InputError);
    EXPECT_THROW(flow.diffuse_cells(field, 1e38F, 1e38F, pool), core::InputError);
    EXPECT_THROW(flow.advect_velocity(std::nanf(""), pool), core::InputError);
}

}  // namespace
}  // namespace pastoso::liquid

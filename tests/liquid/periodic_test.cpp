// The periodic box.
#include "liquid/classic/periodic.hpp"

#include "core/error.hpp"
#include "liquid/flow_cases.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

constexpr double kPi = std::numbers::pi;

double energy(const VelocityField& velocity) {
    const grid::BoxShape& shape = velocity.shape();
    double sum = 0.0;
    for (const int axis : kAxes)
        for (int k = 0; k < shape.nz; ++k)
            for (int j = 0; j < shape.ny; ++j)
                for (int i = 0; i < shape.nx; ++i) {
                    const double u = static_cast<double>(velocity.along(axis).at(i, j, k));
                    sum += u * u;
                }
    return sum;
}

/// The largest divergence of a cell in 1/s.
float largest_periodic_divergence(const VelocityField& velocity) {
    const grid::BoxShape& shape = velocity.shape();
    float largest = 0.0F;
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i)
                largest =
                    std::max(largest, std::abs((velocity.x.at(i + 1, j, k) - velocity.x.at(i, j, k)) +
                                               (velocity.y.at(i, j + 1, k) - velocity.y.at(i, j, k)) +
                                               (velocity.z.at(i, j, k + 1) - velocity.z.at(i, j, k))));
    return largest / shape.cell_m;
}

TEST(PeriodicFlow, ProjectionLeavesNoDivergenceAndChangesNothingTwice) {
    core::ThreadPool pool(2);
    for (const grid::BoxShape shape :
         {grid::BoxShape{64, 64, 64, 1.0F}, grid::BoxShape{20, 15, 9, 1.0F}}) {
        PeriodicFlow flow(shape);
        flow.velocity() = cases::random_velocity(shape, 1);
        flow.project(pool);
        EXPECT_LT(largest_periodic_divergence(flow.velocity()), 2e-5F);
        const VelocityField once = flow.velocity();
        flow.project(pool);
        for (const int axis : kAxes)
            EXPECT_LT(cases::largest_difference(once.along(axis), flow.velocity().along(axis)), 2e-6F);
        EXPECT_GT(energy(once), 0.3 * shape.nx * shape.ny * shape.nz);
    }
}

TEST(PeriodicFlow, AShearWaveDecaysExactly) {
    core::ThreadPool pool(2);
    constexpr int kCells = 64, kSteps = 20;
    const grid::BoxShape shape{kCells, kCells, 4, 1.0F / kCells};
    PeriodicFlow flow(shape, {.viscosity_m2_s = 0.01F});
    const auto wave = [](int j) { return std::sin(4.0 * kPi * (j + 0.5) / kCells); };
    for (int k = 0; k < 4; ++k)
        for (int j = 0; j < kCells; ++j)
            for (int i = 0; i < kCells; ++i)
                flow.velocity().x.at(i, j, k) = static_cast<float>(wave(j));
    for (int step = 0; step < kSteps; ++step)
        flow.diffuse_and_project(0.05F, pool);
    const double decay =
        std::exp(-static_cast<double>(0.01F) * 16.0 * kPi * kPi * kSteps * static_cast<double>(0.05F));
    for (int j = 0; j < kCells; ++j)
        EXPECT_NEAR(flow.velocity().x.at(3, j, 1), decay * wave(j), 5e-6 * decay);
}

struct Decay {
    double amplitude;  ///< against exp(-2 nu t)
    bool grew;
};
Decay taylor_green(int cells, VelocityAdvection scheme, float cells_per_step) {
    core::ThreadPool pool(2);
    const float cell = static_cast<float>(2.0 * kPi) / static_cast<float>(cells);
    const grid::BoxShape shape{cells, cells, 4, cell};
    constexpr float kViscosity = 0.02F;
    PeriodicFlow flow(shape, {.viscosity_m2_s = kViscosity, .velocity_advection = scheme});
    for (int k = 0; k < 4; ++k)
        for (int j = 0; j < cells; ++j)
            for (int i = 0; i < cells; ++i) {
                const float x = static_cast<float>(i) * cell, y = static_cast<float>(j) * cell,
                            half = 0.5F * cell;
                flow.velocity().x.at(i, j, k) = std::sin(x) * std::cos(y + half);
                flow.velocity().y.at(i, j, k) = -std::cos(x + half) * std::sin(y);
            }
    for (const int axis : kAxes)
        fill_periodic_ghosts(flow.velocity().along(axis), pool);
    const double first = energy(flow.velocity());
    const float dt_s = cells_per_step * cell;
    const int steps = static_cast<int>(2.0F / dt_s);
    Decay decay{0.0, false};
    double last = first;
    for (int step = 0; step < steps; ++step) {
        flow.advect_velocity(dt_s, pool);
        flow.diffuse_and_project(dt_s, pool);
        const double now = energy(flow.velocity());
        decay.grew = decay.grew || now > last;
        last = now;
    }
    decay.amplitude = std::sqrt(last / first) / std::exp(-2.0 * static_cast<double>(kViscosity) * steps *
                                                         static_cast<double>(dt_s));
    return decay;
}

TEST(PeriodicFlow, ATaylorGreenVortexDecaysAtItsViscosity) {
    const Decay once = taylor_green(64, VelocityAdvection::Once, 0.5F);
    EXPECT_GT(once.amplitude, 0.97);
    EXPECT_LT(once.amplitude, 1.0);
    EXPECT_FALSE(once.grew);
    const Decay reflected = taylor_green(64, VelocityAdvection::Reflected, 0.5F);
    EXPECT_GT(reflected.amplitude, 0.998);
    EXPECT_LT(reflected.amplitude, 1.0005);
    EXPECT_FALSE(reflected.grew);
}

TEST(PeriodicFlow, ReflectionIsOfSecondOrder) {
    const auto order = [](VelocityAdvection scheme) {
        return std::log2((1.0 - taylor_green(32, scheme, 0.5F).amplitude) /
                         (1.0 - taylor_green(64, scheme, 0.5F).amplitude));
    };
    // Steps shorten with the cells: the splitting's first order against the reflection's second.
    EXPECT_NEAR(order(VelocityAdvection::Once), 1.0, 0.25);
    EXPECT_GT(order(VelocityAdvection::Reflected), 1.7);
}

TEST(PeriodicFlow, RefusesWhatMeansNothing) {
    EXPECT_THROW(PeriodicFlow({0, 8, 8, 1.0F}), core::InputError);
    EXPECT_THROW(PeriodicFlow({8, 8, 8, std::nanf("")}), core::InputError);
    EXPECT_THROW(PeriodicFlow({8, 8, 8, 1.0F}, {.viscosity_m2_s = -1.0F}), core::InputError);
    core::ThreadPool pool(1);
    EXPECT_THROW(PeriodicFlow({8, 8, 8, 1.0F}).diffuse_and_project(std::nanf(""), pool),
                 core::InputError);
}

}  // namespace
}  // namespace pastoso::liquid

// What every way to follow the liquid must do: fall, rest, keep its volume, drain, and break a dam as
// the experiment does.
#include "liquid/surface/marching_cubes.hpp"
#include "random_scenes.hpp"
#include "tank/liquid_tank.hpp"
#include "tank_cases.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include <gtest/gtest.h>

namespace pastoso::tank {
namespace {

using cases::block;
using cases::dam;

/// What the surface of a frame encloses within the box, from its triangles.
double enclosed_m3(const LiquidTank& tank, core::ThreadPool& pool) {
    TankFrame frame = tank.frame(2, pool);
    const liquid::Lattice& lattice = frame.level_m.lattice();
    const glm::vec3 size_m = tank.scene().size_m();
    for (int k = 0; k < lattice.nz; ++k)
        for (int j = 0; j < lattice.ny; ++j)
            for (int i = 0; i < lattice.nx; ++i) {
                float& level = frame.level_m.at(i, j, k);
                const glm::vec3 at_m = lattice.point_m(i, j, k);
                for (const int axis : liquid::kAxes)
                    level = std::max({level, -at_m[axis], at_m[axis] - size_m[axis]});
                level = -level;
            }
    return liquid::volume_m3(liquid::marching_cubes(frame.level_m.view(), 0.0F, pool));
}

/// The middle of the liquid's cells.
glm::dvec3 middle_m(const LiquidTank& tank, core::ThreadPool& pool) {
    const TankFrame frame = tank.frame(1, pool);
    const liquid::Lattice& lattice = frame.level_m.lattice();
    glm::dvec3 sum(0.0);
    double count = 0.0;
    for (int k = 1; k < lattice.nz - 1; ++k)
        for (int j = 1; j < lattice.ny - 1; ++j)
            for (int i = 1; i < lattice.nx - 1; ++i)
                if (frame.level_m.at(i, j, k) < 0.0F) {
                    sum += glm::dvec3(lattice.point_m(i, j, k));
                    count += 1.0;
                }
    return sum / count;
}

std::string name_of(const testing::TestParamInfo<Method>& info) {
    switch (info.param) {
        case Method::Particles:
            return "Particles";
        case Method::LevelSet:
            return "LevelSet";
        case Method::UpwindLevelSet:
            return "UpwindLevelSet";
        default:
            return "ParticleLevelSet";
    }
}

class TankMethod : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(All, TankMethod,
                         testing::Values(Method::Particles, Method::LevelSet, Method::UpwindLevelSet,
                                         Method::ParticleLevelSet),
                         name_of);

TEST_P(TankMethod, DropsFallAsStonesDo) {
    core::ThreadPool pool(2);
    TankScene scene = dam(24, glm::vec3(0.1F));
    scene.method = GetParam();
    scene.liquids = {{{Sphere{{0.4F, 0.5F, 0.7F}, 0.17F}}, {0.4F, 0.0F, 0.0F}, 0.0F}};
    LiquidTank tank(scene);
    const glm::dvec3 start_m = middle_m(tank, pool);
    const double time_s = 0.2, fall_m = 0.5 * 9.81 * time_s * time_s;
    const int steps = tank.advance_to(time_s, pool);
    const glm::dvec3 way_m = middle_m(tank, pool) - start_m;
    // Cells are counted whole, and upwind differences hold a little back.
    const double cells_m = 0.25 / 24.0;
    EXPECT_NEAR(way_m.x, 0.4 * time_s, cells_m);
    EXPECT_NEAR(way_m.y, 0.0, cells_m);
    EXPECT_NEAR(-way_m.z, fall_m * (1.0 + 1.0 / steps), cells_m + 0.03 * fall_m);
}

TEST_P(TankMethod, APoolRests) {
    core::ThreadPool pool(2);
    TankScene scene = dam(16, {1.0F, 1.0F, 0.41F});
    scene.method = GetParam();
    LiquidTank tank(scene);
    const double before_m3 = enclosed_m3(tank, pool);
    for (int step = 0; step < 60; ++step)
        tank.step(0.05, pool);
    // A fifth of a cell: particles lie at random, and flatten as they settle.
    EXPECT_NEAR(enclosed_m3(tank, pool), before_m3, 0.2 / 16.0);
    EXPECT_NEAR(middle_m(tank, pool).z, 0.205, 0.02);
}

TEST_P(TankMethod, ADrainEmptiesIt) {
    core::ThreadPool pool(2);
    TankScene scene = dam(16, {1.0F, 1.0F, 0.3F});
    scene.method = GetParam();
    scene.drains.push_back({block({0.3F, 0.3F, 0.0F}, {0.7F, 0.7F, 0.1F}), 0.0, 1e9});
    LiquidTank tank(scene);
    const double before_m3 = tank.volume_m3(pool);
    tank.advance_to(1.5, pool);
    EXPECT_LT(tank.volume_m3(pool), 0.5 * before_m3);
}

TEST_P(TankMethod, AJetFillsIt) {
    core::ThreadPool pool(2);
    TankScene scene = dam(16, glm::vec3(0.0F));
    scene.liquids.clear();
    scene.method = GetParam();
    scene.jets.push_back(
        {block({0.3F, 0.3F, 0.8F}, {0.7F, 0.7F, 1.0F}), {0.0F, 0.0F, -1.0F}, 1.0F, 0.0, 0.4});
    LiquidTank tank(scene);
    tank.advance_to(0.4, pool);
    // What flowed out and what is in the nozzle; falling faster it grows thin, down to a few cells.
    EXPECT_NEAR(tank.volume_m3(pool), 0.16 * (0.4 + 0.2), 0.2 * 0.16 * 0.6);
    const TankFrame frame = tank.frame(1, pool);
    EXPECT_GT(frame.milk.at(8, 8, 14), 0.9F);
}

TEST_P(TankMethod, AViscousJetStaysFinite) {
    core::ThreadPool pool(2);
    const double speed_m_s = 8.0;
    for (const double viscosity_m2_s : {0.01, 1.0, 10.0}) {
        TankScene scene = dam(16, glm::vec3(0.0F));
        scene.liquids.clear();
        scene.method = GetParam();
        scene.viscosity_m2_s = viscosity_m2_s;
        scene.jets.push_back({block({0.3F, 0.3F, 0.8F}, {0.7F, 0.7F, 1.0F}),
                              {0.0F, 0.0F, -static_cast<float>(speed_m_s)},
                              1.0F,
                              0.0,
                              1e9});
        LiquidTank tank(scene);
        for (int step = 0; step < 100; ++step) {
            tank.step(0.05, pool);
            // Falling a metre adds 4.4 m/s at most; what is squeezed out below turns faster than that.
            ASSERT_LT(tank.fastest_m_s(), 2.5 * speed_m_s) << viscosity_m2_s << " " << step;
        }
        EXPECT_TRUE(cases::is_sound(tank, pool)) << viscosity_m2_s;
        EXPECT_GT(tank.volume_m3(pool), 0.1) << viscosity_m2_s;
    }
}

TEST_P(TankMethod, IsTheSameOnAnyNumberOfThreads) {
    core::ThreadPool single(1), several(3);
    TankScene scene = dam(16, {0.4F, 1.0F, 0.6F});
    scene.method = GetParam();
    scene.solids.push_back({Sphere{{0.7F, 0.5F, 0.2F}, 0.15F}});
    LiquidTank a(scene), b(scene);
    for (int step = 0; step < 20; ++step) {
        a.step(0.05, single);
        b.step(0.05, several);
    }
    EXPECT_EQ(a.velocity(), b.velocity());
}

/// A dam that breaks in a closed tank and sloshes to and fro. The specification allows 2 % once it has
/// settled; upwind differences lose what is thin and are not asked.
class SloshingTank : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Kept, SloshingTank,
                         testing::Values(Method::Particles, Method::LevelSet, Method::ParticleLevelSet),
                         name_of);

TEST_P(SloshingTank, KeepsItsVolumeOverAThousandSteps) {
    core::ThreadPool pool(2);
    TankScene scene = dam(12, {0.5F, 1.0F, 0.5F});
    scene.method = GetParam();
    LiquidTank tank(scene);
    const double before_m3 = tank.volume_m3(pool);
    for (int step = 0; step < 1000; ++step)
        tank.step(1.0, pool);
    // Particles always stand for the same volume: what counts is what their surface encloses.
    const double after_m3 =
        GetParam() == Method::Particles ? enclosed_m3(tank, pool) : tank.volume_m3(pool);
    EXPECT_NEAR(after_m3, before_m3, 0.02 * before_m3);
}

struct Reached {
    double time, front;  ///< T = t sqrt(2 g / a), Z = x / a
};
/// J. C. Martin and W. J. Moyce, Phil. Trans. R. Soc. A 244, 1952, 312-324: columns twice as high as
/// wide, a = 2.25 and 1.125 inches.
constexpr Reached kMartinMoyce[] = {{0.832, 1.217}, {1.219, 1.474}, {1.997, 2.292}, {2.547, 2.995},
                                    {3.345, 4.134}, {0.849, 1.245}, {1.212, 1.443}, {1.602, 1.884},
                                    {2.283, 2.689}, {2.950, 3.728}, {3.598, 4.528}};

/// When the front of a broken dam comes to a place: linear between the moments looked at.
double time_at(const std::vector<Reached>& run, double front) {
    for (std::size_t n = 1; n < run.size(); ++n)
        if (run[n].front >= front) {
            const Reached &a = run[n - 1], &b = run[n];
            return a.time + (b.time - a.time) * (front - a.front) / (b.front - a.front);
        }
    return NAN;
}

TEST(DamBreak, RunsAsMartinAndMoyceSaw) {
    constexpr int kColumn_cells = 16;
    core::ThreadPool pool(2);
    TankScene scene;
    scene.cells = {5 * kColumn_cells, 16, 3 * kColumn_cells};
    scene.cell_m = 1.0 / kColumn_cells;
    scene.liquids = {{block(glm::vec3(0.0F), {1.0F, 1.0F, 2.0F}), glm::vec3(0.0F), 0.0F}};
    LiquidTank tank(scene);
    std::vector<Reached> run = {{0.0, 1.0}};
    while (run.back().front < 4.6) {
        tank.step(0.02, pool);
        std::vector<float> x;
        for (const Particle& particle : tank.particles())
            x.push_back(particle.position_m.x);
        // Without the foremost drops, which fly ahead: one in two thousand.
        const auto front = x.end() - static_cast<std::ptrdiff_t>(x.size() / 2000) - 1;
        std::nth_element(x.begin(), front, x.end());
        run.push_back({tank.time_s() * std::sqrt(2.0 * 9.81), static_cast<double>(*front)});
        ASSERT_LT(run.back().time, 6.0);
    }
    std::vector<double> leads;
    for (const Reached& seen : kMartinMoyce)
        leads.push_back(seen.time - time_at(run, seen.front));
    const double mean =
        std::accumulate(leads.begin(), leads.end(), 0.0) / static_cast<double>(leads.size());
    // The experiment's gate takes time to lift: simulations lead by a nearly constant time.
    EXPECT_GT(mean, 0.1);
    EXPECT_LT(mean, 0.35);
    for (const double lead : leads)
        EXPECT_NEAR(lead, mean, 0.12);
    RecordProperty("mean_lead", std::to_string(mean));
}

}  // namespace
}  // namespace pastoso::tank

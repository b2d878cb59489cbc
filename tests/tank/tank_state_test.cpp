// A tank that goes on from a state becomes what it would have become.
#include "core/error.hpp"
#include "tank/liquid_tank.hpp"
#include "tank_cases.hpp"

#include <string>

#include <gtest/gtest.h>

namespace pastoso::tank {
namespace {

using cases::block;
using cases::dam;

/// All that can happen in a tank, from the first step on.
TankScene lively(Method method) {
    TankScene scene = dam(16, {0.4F, 1.0F, 0.5F});
    scene.method = method;
    scene.viscosity_m2_s = 2e-3;
    scene.confinement = 0.1;
    scene.liquids.push_back({{Sphere{{0.6F, 0.5F, 0.7F}, 0.2F}}, {0.0F, 0.0F, -1.0F}, 1.0F});
    scene.solids.push_back({Cylinder{{0.7F, 0.5F, -0.1F}, {0.7F, 0.5F, 0.4F}, 0.15F}});
    scene.jets.push_back({block({0.0F, 0.4F, 0.7F}, {0.15F, 0.6F, 0.9F}), {2.0F, 0.0F, 0.0F}, 0.5F});
    scene.drains.push_back({block({0.3F, 0.0F, 0.0F}, {0.5F, 0.2F, 0.1F})});
    scene.wind = {3.0, 30.0, 10.0};
    return scene;
}

class TankStates : public testing::TestWithParam<Method> {};

TEST_P(TankStates, WhatFollowsIsTheSameToTheLastBit) {
    const TankScene scene = lively(GetParam());
    core::ThreadPool pool(2), one(1);
    LiquidTank whole(scene);
    for (int step = 0; step < 23; ++step)
        whole.step(0.01, pool);
    const TankState middle = whole.state();
    for (int step = 0; step < 27; ++step)
        whole.step(0.01, pool);
    LiquidTank other(scene);
    other.set_state(middle, one);
    EXPECT_EQ(other.state(), middle);
    for (int step = 0; step < 27; ++step)
        other.step(0.01, one);
    EXPECT_EQ(other.state(), whole.state());
    EXPECT_NE(other.state(), middle);
    const TankFrame frame = other.frame(2, one), same = whole.frame(2, pool);
    const liquid::Lattice& lattice = frame.level_m.lattice();
    for (int k = 0; k < lattice.nz; ++k)
        for (int j = 0; j < lattice.ny; ++j)
            for (int i = 0; i < lattice.nx; ++i)
                ASSERT_EQ(frame.level_m.at(i, j, k), same.level_m.at(i, j, k));
    EXPECT_EQ(frame.milk, same.milk);
}

/// A tank that has been elsewhere forgets it.
TEST_P(TankStates, AreTakenByTanksThatHaveRun) {
    const TankScene scene = lively(GetParam());
    core::ThreadPool pool(2);
    LiquidTank tank(scene), other(scene);
    for (int step = 0; step < 8; ++step)
        tank.step(0.01, pool);
    const TankState early = tank.state();
    for (int step = 0; step < 12; ++step)
        tank.step(0.01, pool);
    const TankState late = tank.state();
    tank.set_state(early, pool);
    for (int step = 0; step < 12; ++step)
        tank.step(0.01, pool);
    EXPECT_EQ(tank.state(), late);
}

TEST_P(TankStates, OfOtherTanksAreRefused) {
    core::ThreadPool pool(1);
    const TankState state = LiquidTank(lively(GetParam())).state();
    TankScene scene = dam(20, {0.4F, 1.0F, 0.5F});
    scene.method = GetParam();
    LiquidTank larger(scene);
    EXPECT_THROW(larger.set_state(state, pool), core::InputError);
    scene = lively(GetParam() == Method::ParticleLevelSet ? Method::LevelSet : Method::ParticleLevelSet);
    LiquidTank followed_otherwise(scene);
    EXPECT_THROW(followed_otherwise.set_state(state, pool), core::InputError);
    scene = lively(GetParam() == Method::Particles ? Method::LevelSet : Method::Particles);
    LiquidTank with_other_method(scene);
    EXPECT_THROW(with_other_method.set_state(state, pool), core::InputError);
}

std::string name_of(const testing::TestParamInfo<Method>& tested) {
    constexpr const char* kNames[] = {"Particles", "LevelSet", "UpwindLevelSet", "ParticleLevelSet"};
    return kNames[static_cast<int>(tested.param)];
}

INSTANTIATE_TEST_SUITE_P(All, TankStates,
                         testing::Values(Method::Particles, Method::LevelSet, Method::UpwindLevelSet,
                                         Method::ParticleLevelSet),
                         name_of);

TEST(TankState, AParticleOutsideIsRefused) {
    core::ThreadPool pool(1);
    LiquidTank tank(dam(16, {0.4F, 1.0F, 0.5F}));
    TankState state = tank.state();
    state.liquid.particles[5].position_m.y = 1.01F;
    EXPECT_THROW(tank.set_state(state, pool), core::InputError);
}

TEST(TankState, WhatJetsBringAndDrainsTakeIsCounted) {
    core::ThreadPool pool(1);
    TankScene scene = dam(16, {1.0F, 1.0F, 0.3F});
    LiquidTank still(scene);
    still.advance_to(0.1, pool);
    EXPECT_EQ(still.brought_m3(), 0.0);
    scene.drains.push_back({block({0.3F, 0.3F, 0.0F}, {0.6F, 0.6F, 0.2F})});
    LiquidTank drained(scene);
    const double before_m3 = drained.volume_m3(pool);
    drained.advance_to(0.1, pool);
    EXPECT_LT(drained.brought_m3(), -0.01);
    // Particles are only taken, none is lost.
    EXPECT_NEAR(drained.volume_m3(pool), before_m3 + drained.brought_m3(), 1e-9);
}

}  // namespace
}  // namespace pastoso::tank

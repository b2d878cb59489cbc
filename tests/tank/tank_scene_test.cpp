#include "tank/tank_scene.hpp"

#include "core/error.hpp"

#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::tank {
namespace {

using ::testing::HasSubstr;

std::string fault(const TankScene& scene) {
    try {
        check_tank(scene);
    } catch (const core::InputError& error) {
        return error.what();
    }
    return "";
}

const Shape kBall{Sphere{{0.1F, 0.1F, 0.1F}, 0.05F}}, kNothing{Sphere{}};

TEST(TankScene, TheUsualTankIsPossible) {
    EXPECT_EQ(fault({}), "");
}

TEST(TankScene, EveryNumberHasItsRange) {
    for (const TankNumber& number : tank_numbers()) {
        for (const double bad :
             {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
              2.0 * number.most + 1.0, number.least - 1.0}) {
            TankScene scene;
            scene.*number.value = bad;
            EXPECT_THAT(fault(scene), HasSubstr(std::string(number.key) + " is ")) << bad;
        }
        for (const double good : {number.least, number.most}) {
            TankScene scene;
            scene.*number.value = good;
            EXPECT_EQ(fault(scene), "") << number.key << " = " << good;
        }
    }
}

TEST(TankScene, WhatCannotBeIsNamed) {
    const auto with = [](auto change) {
        TankScene scene;
        scene.liquids = {{kBall}};
        scene.jets = {{kBall}};
        scene.drains = {{kBall}};
        scene.solids = {kBall};
        EXPECT_EQ(fault(scene), "");
        change(scene);
        return fault(scene);
    };
    using S = TankScene;
    EXPECT_EQ(with([](S& s) { s.cells.y = 7; }), "cells is 7, not between 8 and 256.");
    EXPECT_THAT(with([](S& s) { s.liquids[0].shape = kNothing; }),
                HasSubstr("liquids[0]: sphere: radius_m is 0"));
    EXPECT_THAT(with([](S& s) { s.solids[0] = kNothing; }),
                HasSubstr("solids[0]: sphere: radius_m is 0"));
    EXPECT_THAT(with([](S& s) { s.jets[0].shape = kNothing; }),
                HasSubstr("jets[0]: sphere: radius_m is 0"));
    EXPECT_THAT(with([](S& s) { s.drains[0].shape = kNothing; }),
                HasSubstr("drains[0]: sphere: radius_m is 0"));
    EXPECT_THAT(with([](S& s) { s.liquids[0].velocity_m_s.z = -101; }),
                HasSubstr("liquids[0].velocity_m_s is -101"));
    EXPECT_THAT(with([](S& s) { s.liquids[0].milk = 1.5F; }), HasSubstr("liquids[0].milk is 1.5"));
    EXPECT_THAT(with([](S& s) { s.jets[0].velocity_m_s.x = 101; }),
                HasSubstr("jets[0].velocity_m_s is 101"));
    EXPECT_THAT(with([](S& s) { s.jets[0].milk = -1; }), HasSubstr("jets[0].milk is -1"));
    EXPECT_THAT(with([](S& s) { s.jets[0].from_s = -1; }), HasSubstr("jets[0].from_s is -1"));
    EXPECT_THAT(with([](S& s) {
                    s.drains[0].from_s = 3;
                    s.drains[0].until_s = 2;
                }),
                HasSubstr("drains[0].until_s is 2, not between 3 and"));
    EXPECT_THAT(with([](S& s) { s.wind.speed_m_s = -1; }), HasSubstr("wind.speed_m_s is -1"));
    EXPECT_THAT(with([](S& s) { s.wind.direction_deg = 1e5; }), HasSubstr("direction_deg is 100000"));
    EXPECT_THAT(with([](S& s) { s.wind.drag_per_s = -2; }), HasSubstr("wind.drag_per_s is -2"));
    EXPECT_THAT(with([](S& s) { s.wind.until_s = 2e9; }), HasSubstr("wind.until_s is 2e+09"));
}

}  // namespace
}  // namespace pastoso::tank

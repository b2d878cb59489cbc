// Enright's deformation at the size that the specification names.
#include "tank/level_cases.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::tank {
namespace {

TEST(Enright, ParticlesKeepTheVolume) {
    core::ThreadPool pool(2);
    const cases::Followed pulled =
        cases::follow(cases::Flow::Enright, 48, {.particles_per_cell = 32}, pool);
    // The specification's bound is 4 %; measured -0.02 % and 0.031.
    EXPECT_LT(std::abs(pulled.volume_error), 0.015);
    EXPECT_LT(pulled.shape_error, 0.05);
}

}  // namespace
}  // namespace pastoso::tank

// Scenes drawn at random, run while what they hold is checked.
#pragma once

#include "tank/liquid_tank.hpp"

#include <cstdint>

#include <gtest/gtest.h>

namespace pastoso::tank::cases {

/// Of 12^3 cells: bodies, solids, jets, drains, wind, viscosity, confinement and the way to follow the
/// liquid, all drawn from the seed.
TankScene random_scene(std::uint32_t seed);

/// The liquid is within the box, and every number of it is one.
testing::AssertionResult is_sound(const LiquidTank& tank, core::ThreadPool& pool);

/// Twelve steps of each of the scenes.
void run_random_scenes(std::uint32_t first_seed, std::uint32_t count);

}  // namespace pastoso::tank::cases

// White noise of paint on a rough support with random properties: what a solver must survive.
#pragma once

#include <cstdint>

namespace pastoso::film::test {

/// Runs the paint of a seed for 20 + `steps` steps at half the stability limit and expects it to stay
/// finite, non-negative, exact in volume and without pile-ups. Returns whether face speeds were clamped
/// after the first 20 steps: a clamp hides instability, so it is counted.
bool run_random_paint(std::uint32_t seed, int steps);

}  // namespace pastoso::film::test

// White noise of paint on a rough support with random properties: what a solver must survive.
#pragma once

#include "film/film_bench.hpp"
#include "film/schemes.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

namespace pastoso::film::test {

enum class EdgeKind { Periodic, Wall, Open, Mixed };
std::string name_of(EdgeKind edges);

/// Every scheme on every kind of edge, and the name of such a case.
using PaintCase = std::tuple<Scheme, EdgeKind>;
std::vector<PaintCase> all_paint_cases();
std::string name_of(const PaintCase& paint_case);

struct RandomPaint {
    std::uint32_t seed = 0;
    Scene scene;
    double largest_mm = 1;                      ///< thickness of the start
    std::function<double(int, int)> thickness;  ///< white noise, a third of it dry
    std::function<double(int, int)> support;
};

/// The paint of a seed: viscosity, tension, gravity, yield over decades; yield, contact angle, alpha
/// range, inertia, full curvature and slip each on or off; thickness white noise with dry cells; the
/// support smooth, sloping or rough; a canvas of one to four tiles.
RandomPaint random_paint(std::uint32_t seed, EdgeKind edges);

/// What runs did that is neither right nor wrong in itself. Rough starts may touch the speed clamp in
/// their first 20 steps, a healthy run not after them: a clamp hides instability, so it is counted.
struct RandomRuns {
    int paints = 0, paints_clamped_late = 0;
    std::int64_t steps = 0;
    std::int64_t early_faces = 0, early_clamps = 0;  ///< faces stepped and clamped in the first 20 steps
    std::int64_t late_faces = 0, late_clamps = 0;    ///< after them
    std::int64_t large_steps = 0, rejected_steps = 0, sweeps = 0;  ///< of large steps
    std::int64_t cells = 0, limited_cells = 0;                     ///< stepped by large steps
    double fullest = 0;  ///< thickest paint over what may be expected of its case, at most 1
};

struct SeedRange {
    std::uint32_t first_seed = 1;
    int count = 1;
    int steps = 100;  ///< after the first 20
};

/// Runs the paints of some seeds and expects (as test failures that name the seed) that each stays
/// finite, non-negative and exact in volume and pigment, run-off included, and that it piles up nowhere,
/// above all not beyond what a cell may hold.
RandomRuns run_random_paints(const Scheme& scheme, EdgeKind edges, const SeedRange& seeds);

/// Prints the counts and expects that clamps are as rare as in a healthy solver, and that large steps
/// seldom have to be tried again or cut.
void expect_calm(const RandomRuns& runs);

}  // namespace pastoso::film::test

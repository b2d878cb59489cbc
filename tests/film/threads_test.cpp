// The same film on any number of threads: small, so that the thread sanitizer can run it.
#include "film/film_bench.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

struct Run {
    film::Scheme scheme;
    double step_s, seconds;
};

FilmState drip(const Run& run, int threads) {
    SolverOptions options;
    options.scheme = run.scheme;
    Bench bench({.width = 200,
                 .height = 150,
                 .gravity = 1,
                 .force_x = 0.3,
                 .force_y = 0.5,
                 .tension = 3,
                 .alpha_min = 0.5,
                 .alpha_max = 1.2,
                 .tan_advancing = 0.5,
                 .tan_receding = 0.2,
                 .slip_cells = 0.2,
                 .threads = threads,
                 .solver = options});
    bench.fill([](int x, int y) {
        const auto blob = [&](double centre_x, double centre_y, double radius, double height) {
            const double r = std::hypot(x + 0.5 - centre_x, y + 0.5 - centre_y) / radius;
            return r < 1 ? height * (1 - r * r) : 0.0;
        };
        return blob(70, 60, 18, 3.5) + blob(20, 50, 9, 1);
    });
    bench.tint(2, [](int x, int y) { return x + y; });
    bench.run(run.step_s, run.seconds);
    return bench.state;
}

class Threads : public testing::TestWithParam<Run> {};

TEST_P(Threads, AnyNumberGivesTheSameBits) {
    const std::uint64_t reference = state_hash(drip(GetParam(), 1));
    for (const int threads : {2, 3})
        EXPECT_EQ(state_hash(drip(GetParam(), threads)), reference) << threads;
}
INSTANTIATE_TEST_SUITE_P(Schemes, Threads,
                         testing::Values(Run{film::Scheme::Explicit, 0.04, 24.0},
                                         Run{film::Scheme::LargeStep, 2.0, 24.0}),
                         [](const auto& test) {
                             return test.param.scheme == film::Scheme::Explicit ? "Explicit"
                                                                                : "LargeStep";
                         });

}  // namespace
}  // namespace pastoso::film::test

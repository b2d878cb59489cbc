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
    Scene scene = runny(200, 150);
    scene.threads = threads;
    scene.solver.scheme = run.scheme;
    Bench bench(scene);
    bench.fill([](int x, int y) { return blob(x, y, 70, 60, 18, 3.5) + blob(x, y, 20, 50, 9, 1); });
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

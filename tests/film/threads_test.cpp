// The same film on any number of threads: small, so that the thread sanitizer can run it.
#include "film/film_bench.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

FilmState drip(int threads) {
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
                 .threads = threads});
    bench.fill([](int x, int y) {
        const auto blob = [&](double centre_x, double centre_y, double radius, double height) {
            const double r = std::hypot(x + 0.5 - centre_x, y + 0.5 - centre_y) / radius;
            return r < 1 ? height * (1 - r * r) : 0.0;
        };
        return blob(70, 60, 18, 3.5) + blob(20, 50, 9, 1);
    });
    bench.tint(2, [](int x, int y) { return x + y; });
    bench.run(0.04, 24.0);
    return bench.state;
}

TEST(Threads, AnyNumberGivesTheSameBits) {
    const std::uint64_t reference = state_hash(drip(1));
    for (const int threads : {2, 3})
        EXPECT_EQ(state_hash(drip(threads)), reference) << threads;
}

}  // namespace
}  // namespace pastoso::film::test

// The laws of property_test.cpp with ten times the steps: on the paints of 240 other fixed seeds, and on
// as many that nobody has seen, with seeds from the clock. A failure names its seed;
// PASTOSO_FIRST_SEED=<the printed first seed> repeats the whole run.
#include "film/random_paint.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

std::uint32_t fresh_seed() {
    if (const char* wanted = std::getenv("PASTOSO_FIRST_SEED"))
        return static_cast<std::uint32_t>(std::stoul(wanted));
    return static_cast<std::uint32_t>(std::chrono::system_clock::now().time_since_epoch().count() /
                                      1000);
}

constexpr int kPaints = 60;  ///< for each kind of edge

class LongRunningPaint : public testing::TestWithParam<PaintCase> {};

TEST_P(LongRunningPaint, OfKnownSeedsStaysFiniteExactAndCalm) {
    const auto& [scheme, edges] = GetParam();
    const auto first_seed = static_cast<std::uint32_t>(100'000 * (1 + static_cast<int>(edges)));
    expect_calm(run_random_paints(
        scheme, edges, {.first_seed = first_seed, .count = kPaints, .steps = 10 * scheme.random_steps}));
}

TEST_P(LongRunningPaint, OfFreshSeedsStaysFiniteExactAndCalm) {
    const auto& [scheme, edges] = GetParam();
    const std::uint32_t first_seed = fresh_seed();
    std::printf("PASTOSO_FIRST_SEED=%u repeats this\n", first_seed);
    SCOPED_TRACE(testing::Message() << "PASTOSO_FIRST_SEED=" << first_seed);
    expect_calm(run_random_paints(
        scheme, edges, {.first_seed = first_seed, .count = kPaints, .steps = 10 * scheme.random_steps}));
}
INSTANTIATE_TEST_SUITE_P(Schemes, LongRunningPaint, testing::ValuesIn(all_paint_cases()),
                         [](const auto& test) { return name_of(test.param); });

}  // namespace
}  // namespace pastoso::film::test

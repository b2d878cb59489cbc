// The laws of property_test.cpp on paints that nobody has seen: seeds from the clock, ten times the
// steps. A failure names its seed; PASTOSO_FIRST_SEED=<the printed first seed> repeats the whole run.
#include "film/random_paint.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

std::uint32_t fresh_seed() {
    if (const char* wanted = std::getenv("PASTOSO_FIRST_SEED"))
        return static_cast<std::uint32_t>(std::stoul(wanted));
    return static_cast<std::uint32_t>(std::chrono::system_clock::now().time_since_epoch().count() /
                                      1000);
}

using PaintCase = std::tuple<Scheme, EdgeKind>;
class FreshPaint : public testing::TestWithParam<PaintCase> {};

TEST_P(FreshPaint, StaysFiniteExactAndCalm) {
    const auto& [scheme, edges] = GetParam();
    const std::uint32_t first_seed = fresh_seed();
    std::printf("PASTOSO_FIRST_SEED=%u repeats this\n", first_seed);
    SCOPED_TRACE(testing::Message() << "PASTOSO_FIRST_SEED=" << first_seed);
    expect_calm(
        run_random_paints(scheme, edges, {.first_seed = first_seed, .count = 60, .steps = 1500}));
}
INSTANTIATE_TEST_SUITE_P(Schemes, FreshPaint,
                         testing::Combine(testing::ValuesIn(all_schemes()),
                                          testing::Values(EdgeKind::Periodic, EdgeKind::Wall,
                                                          EdgeKind::Open, EdgeKind::Mixed)),
                         [](const auto& test) {
                             return std::get<0>(test.param).name + name_of(std::get<1>(test.param));
                         });

}  // namespace
}  // namespace pastoso::film::test

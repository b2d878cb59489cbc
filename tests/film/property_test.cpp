// Laws that hold for any paint, tried on white noise with random properties: 240 fixed seeds for
// each scheme, and as many others and fresh ones in the long set (long_property_test.cpp).
#include "film/random_paint.hpp"

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

class AnyPaint : public testing::TestWithParam<PaintCase> {};

TEST_P(AnyPaint, StaysFiniteExactAndCalm) {
    const auto& [scheme, edges] = GetParam();
    const auto first_seed = static_cast<std::uint32_t>(1000 * (1 + static_cast<int>(edges)));
    expect_calm(run_random_paints(
        scheme, edges,
        {.first_seed = first_seed, .count = scheme.random_paints, .steps = scheme.random_steps}));
}
INSTANTIATE_TEST_SUITE_P(Schemes, AnyPaint, testing::ValuesIn(all_paint_cases()),
                         [](const auto& test) { return name_of(test.param); });

}  // namespace
}  // namespace pastoso::film::test

// Laws that hold for any paint, tried on white noise with random properties: 240 fixed seeds for
// each scheme, and as many others and fresh ones in the long set (long_property_test.cpp).
#include "film/random_paint.hpp"

#include <tuple>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

using PaintCase = std::tuple<Scheme, EdgeKind>;
class AnyPaint : public testing::TestWithParam<PaintCase> {};

TEST_P(AnyPaint, StaysFiniteExactAndCalm) {
    const auto& [scheme, edges] = GetParam();
    const auto first_seed = static_cast<std::uint32_t>(1000 * (1 + static_cast<int>(edges)));
    expect_calm(run_random_paints(
        scheme, edges,
        {.first_seed = first_seed, .count = scheme.random_paints, .steps = scheme.random_steps}));
}
INSTANTIATE_TEST_SUITE_P(Schemes, AnyPaint,
                         testing::Combine(testing::ValuesIn(all_schemes()),
                                          testing::Values(EdgeKind::Periodic, EdgeKind::Wall,
                                                          EdgeKind::Open, EdgeKind::Mixed)),
                         [](const auto& test) {
                             return std::get<0>(test.param).name + name_of(std::get<1>(test.param));
                         });

}  // namespace
}  // namespace pastoso::film::test

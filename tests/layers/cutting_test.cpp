#include "layers/cutting.hpp"

#include "layers/merging.hpp"
#include "layers/random_layer.hpp"
#include "layers/sums.hpp"

#include <gtest/gtest.h>

namespace pastoso::layers {
namespace {

using film::FilmState;
using test::sums_of;

grid::Mask triangle() {
    return grid::polygon_mask(test::kShape, {{10, 5}, {140, 20}, {40, 66}});
}

grid::Mask everything() {
    return grid::inverted(grid::Mask(test::kShape));
}

bool same_paint(const FilmState& a, const FilmState& b, int x, int y) {
    return a.thickness.at(x, y) == b.thickness.at(x, y) && a.paint.at(x, y) == b.paint.at(x, y) &&
           a.lower.thickness.at(x, y) == b.lower.thickness.at(x, y) &&
           a.worked.thickness.at(x, y) == b.worked.thickness.at(x, y) &&
           a.media.foreign.at(x, y) == b.media.foreign.at(x, y) &&
           a.support_mm.at(x, y) == b.support_mm.at(x, y) &&
           a.strata.soluble_thickness.at(x, y) == b.strata.soluble_thickness.at(x, y) &&
           a.strata.soluble_pigment.at(x, y) == b.strata.soluble_pigment.at(x, y) &&
           a.strata.optics.at(x, y) == b.strata.optics.at(x, y) &&
           a.strata.uppermost.at(x, y) == b.strata.uppermost.at(x, y);
}

TEST(Cutting, EveryCellGoesToOnePart) {
    const FilmState layer = test::random_layer(3), bare = test::bare_layer();
    const grid::Mask mask = triangle();
    const CutLayer parts = cut(layer, mask);
    for (int y = 0; y < test::kShape.height; ++y)
        for (int x = 0; x < test::kShape.width; ++x) {
            const bool chosen = mask.at(x, y) != 0;
            ASSERT_TRUE(same_paint(chosen ? parts.inside : parts.outside, layer, x, y));
            ASSERT_TRUE(same_paint(chosen ? parts.outside : parts.inside, bare, x, y));
        }
}

TEST(Cutting, LosesNothing) {
    core::ThreadPool pool(2);
    for (std::uint32_t seed = 1; seed < 5; ++seed) {
        const FilmState layer = test::random_layer(seed);
        const CutLayer parts = cut(layer, triangle());
        EXPECT_EQ(sums_of(parts.inside) + sums_of(parts.outside), sums_of(layer));
        EXPECT_EQ(sums_of(merged(parts.outside, parts.inside, 1.0, pool)), sums_of(layer));
    }
}

TEST(Cutting, AllOrNothingIsTheLayerItself) {
    FilmState layer = test::random_layer(3);
    EXPECT_EQ(film::state_hash(cut(layer, grid::Mask(test::kShape)).outside), film::state_hash(layer));
    const CutLayer parts = cut(layer, everything());
    EXPECT_EQ(parts.outside.strata.evaporated, layer.strata.evaporated);
    layer.strata.evaporated = 0;
    EXPECT_EQ(film::state_hash(parts.inside), film::state_hash(layer));
    EXPECT_EQ(film::totals(parts.outside).thickness, 0);
    EXPECT_EQ(film::dried_totals(parts.outside.strata), film::DriedTotals{});
}

TEST(Cutting, FixedPaintIsSharedByItsThickness) {
    const FilmState layer = test::random_layer(4);
    EXPECT_EQ(fixed_relief_quanta(layer), layer.strata.fixed.thickness);
    const CutLayer parts = cut(layer, triangle());
    EXPECT_EQ(parts.inside.strata.fixed.thickness, fixed_relief_quanta(parts.inside));
    EXPECT_EQ(parts.outside.strata.fixed.thickness, fixed_relief_quanta(parts.outside));
}

TEST(Cutting, NothingPushesAcrossTheBorder) {
    FilmState layer = test::random_layer(5);
    for (int y = 0; y < test::kShape.height; ++y)
        for (int x = 0; x < test::kShape.width; ++x) {
            layer.velocity_x.set(x, y, 1.0F);
            layer.velocity_y.set(x, y, 2.0F);
        }
    const grid::Mask mask = grid::polygon_mask(test::kShape, {{30, 0}, {150, 0}, {150, 70}, {30, 70}});
    const CutLayer parts = cut(layer, mask);
    EXPECT_EQ(parts.outside.velocity_x.at(28, 9), 1.0F);
    EXPECT_EQ(parts.outside.velocity_x.at(29, 9), 0.0F);
    EXPECT_EQ(parts.inside.velocity_x.at(29, 9), 0.0F);
    EXPECT_EQ(parts.inside.velocity_x.at(30, 9), 1.0F);
    EXPECT_EQ(parts.outside.velocity_y.at(29, 9), 2.0F);
    EXPECT_EQ(parts.inside.velocity_y.at(30, 9), 2.0F);
}

}  // namespace
}  // namespace pastoso::layers

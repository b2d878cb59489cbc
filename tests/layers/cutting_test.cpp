#include "layers/cutting.hpp"

#include "layers/merging.hpp"
#include "layers/random_layer.hpp"
#include "layers/sums.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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

/// Softer from left to right, and whole and nothing besides.
grid::Mask slope() {
    grid::Mask mask(test::kShape);
    for (int y = 0; y < test::kShape.height; ++y)
        for (int x = 0; x < test::kShape.width; ++x)
            mask.set(x, y, static_cast<std::uint8_t>(std::clamp(300 - 3 * x + y, 0, 255)));
    return mask;
}

TEST(Cutting, SoftEdgesLoseNothing) {
    core::ThreadPool pool(2);
    for (std::uint32_t seed = 1; seed < 5; ++seed) {
        const FilmState layer = test::random_layer(seed);
        const CutLayer parts = cut(layer, slope());
        EXPECT_EQ(sums_of(parts.inside) + sums_of(parts.outside), sums_of(layer));
        const test::Sums again = sums_of(merged(parts.outside, parts.inside, 1.0, pool));
        EXPECT_EQ(again.thickness, sums_of(layer).thickness);
        EXPECT_EQ(again.pigment, sums_of(layer).pigment);
        EXPECT_EQ(parts.inside.strata.fixed.thickness, fixed_relief_quanta(parts.inside));
        EXPECT_EQ(parts.outside.strata.fixed.thickness, fixed_relief_quanta(parts.outside));
        EXPECT_GT(parts.inside.strata.fixed.thickness, 0);
        EXPECT_GT(parts.outside.strata.fixed.thickness, 0);
    }
}

TEST(Cutting, OfASoftCellTheInsideHasItsShare) {
    const FilmState layer = test::random_layer(3);
    const grid::Mask mask = slope();
    const CutLayer parts = cut(layer, mask);
    int soft = 0;
    for (int y = 0; y < test::kShape.height; ++y)
        for (int x = 0; x < test::kShape.width; ++x) {
            const std::int32_t whole = layer.thickness.at(x, y);
            const std::int32_t inside = parts.inside.thickness.at(x, y);
            ASSERT_EQ(inside, grid::share_of(whole, mask.at(x, y)));
            ASSERT_EQ(parts.outside.thickness.at(x, y), whole - inside);
            for (int k = 0; k < film::kPaintChannels; ++k)
                ASSERT_EQ(parts.inside.paint.at(x, y)[k] + parts.outside.paint.at(x, y)[k],
                          layer.paint.at(x, y)[k]);
            ASSERT_EQ(parts.inside.support_mm.at(x, y) + parts.outside.support_mm.at(x, y),
                      layer.support_mm.at(x, y));
            soft += inside > 0 && inside < whole ? 1 : 0;
        }
    EXPECT_GT(soft, 500);
}

TEST(Cutting, ThePartsOfASoftCellArePossible) {
    for (std::uint32_t seed = 1; seed < 5; ++seed) {
        const CutLayer parts = cut(test::random_layer(seed), slope());
        for (const FilmState* part : {&parts.inside, &parts.outside})
            for (int y = 0; y < test::kShape.height; ++y)
                for (int x = 0; x < test::kShape.width; ++x) {
                    const film::LowerCell lower{part->lower.thickness.at(x, y),
                                                part->lower.paint.at(x, y)};
                    const std::int32_t thickness = part->thickness.at(x, y);
                    ASSERT_TRUE(film::is_part_of(lower, thickness, part->paint.at(x, y)));
                    ASSERT_LE(part->worked.thickness.at(x, y), thickness);
                    const film::MediaCell media = part->media.foreign.at(x, y);
                    ASSERT_LE(std::accumulate(media.begin(), media.end(), std::int64_t{0}), thickness);
                    const std::int64_t relief =
                        std::llround(part->support_mm.at(x, y) / film::kThicknessQuantum_mm);
                    ASSERT_GE(relief, part->strata.soluble_thickness.at(x, y));
                    ASSERT_EQ(part->strata.soluble_thickness.at(x, y) % film::kQuantaPerSupport, 0);
                }
    }
}

TEST(Cutting, FixedPaintFadesByItsShare) {
    const FilmState layer = test::random_layer(3);
    grid::Mask half(test::kShape);
    for (int tile = 0; tile < half.tile_count(); ++tile)
        std::fill_n(half.write(tile), grid::kTileCells, std::uint8_t{51});
    const CutLayer parts = cut(layer, half);
    for (int y = 0; y < test::kShape.height; ++y)
        for (int x = 0; x < test::kShape.width; ++x) {
            const film::StrataOptics& whole = layer.strata.optics.at(x, y);
            ASSERT_EQ(parts.inside.strata.optics.at(x, y), film::faded(whole, 0.2F));
            ASSERT_EQ(parts.outside.strata.optics.at(x, y), film::faded(whole, 0.8F));
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

#include "layers/apart.hpp"

#include "film/support/support.hpp"
#include "layers/random_layer.hpp"

#include <gtest/gtest.h>

namespace pastoso::layers {
namespace {

Heights linen() {
    core::ThreadPool pool(1);
    return film::named_support("linen", test::kShape, test::kCell_mm, 0.0, pool);
}

TEST(Apart, LaidOnAndLiftedOffIsTheSameToTheBit) {
    const film::FilmState layer = test::random_layer(1);
    const film::FilmState again = lifted_off(laid_on(layer, linen()), linen());
    EXPECT_EQ(film::state_hash(again), film::state_hash(layer));
}

TEST(Apart, WhatLiesOnTheBaseSharesItsBareTiles) {
    const Heights base = linen();
    const film::FilmState film = laid_on(test::random_layer(1), base);
    EXPECT_TRUE(film.support_mm.shares_tile(base, 2));
    EXPECT_FALSE(film.support_mm.shares_tile(base, 0));
    EXPECT_TRUE(lifted_off(film, base).support_mm.is_background(2));
}

TEST(Apart, HeightsAreTheSumOfWhatLiesThere) {
    const film::FilmState layer = test::random_layer(2);
    const Heights base = linen();
    Heights heights = base;
    raise_by(layer, heights);
    double most_mm = 0.0;
    for (int y = 0; y < test::kShape.height; ++y) {
        for (int x = 0; x < test::kShape.width; ++x) {
            const double paint_mm =
                layer.support_mm.at(x, y) + film::thickness_mm(layer.thickness.at(x, y));
            // Wet paint is rounded to the nearest step of the support.
            EXPECT_NEAR(heights.at(x, y) - base.at(x, y), paint_mm, 0.51 * film::kSupportQuantum_mm);
            most_mm = std::max(most_mm, paint_mm);
        }
    }
    EXPECT_GT(most_mm, 0.3);
}

TEST(Lifter, FindsWhatHasChanged) {
    Lifter lifter;
    film::FilmState film = laid_on(test::random_layer(3), linen());
    Heights base = linen();
    const film::FilmState first = lifter.lifted_off(film, linen());
    EXPECT_EQ(film::state_hash(first), film::state_hash(test::random_layer(3)));
    film.support_mm.set(3, 4, film.support_mm.at(3, 4) + 0.25F);
    const film::FilmState second = lifter.lifted_off(film, linen());
    EXPECT_EQ(second.support_mm.at(3, 4), first.support_mm.at(3, 4) + 0.25F);
    base.set(70, 10, base.at(70, 10) - 0.125F);
    const film::FilmState third = lifter.lifted_off(film, base);
    EXPECT_EQ(third.support_mm.at(70, 10), second.support_mm.at(70, 10) + 0.125F);
    EXPECT_EQ(third.support_mm.at(3, 4), second.support_mm.at(3, 4));
}

}  // namespace
}  // namespace pastoso::layers

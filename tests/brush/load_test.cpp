#include "brush/brush.hpp"
#include "brush/studio.hpp"
#include "brush/wick.hpp"

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

TEST(Load, FillsAccordingToBody) {
    Brush brush(studio::flat_preset(20.0));
    const Contents taken = brush.load(studio::dark_paint(), 1.0);
    EXPECT_LT(studio::balance_error(brush.contents(), taken), 1e-14);
    for (int i = 0; i < 300; ++i) {
        EXPECT_NEAR(brush.fill_of(i), std::min(0.4 + 0.6 * brush.tip.bristles[i].body, 1.15), 1e-6);
    }
}

TEST(Load, TopsUpWhatIsMissing) {
    Brush brush(studio::flat_preset(20.0));
    Contents taken = brush.load(studio::dark_paint(), 0.5);
    const double half_mm3 = taken.volume_mm3;
    EXPECT_EQ(brush.load(studio::light_paint(), 0.5).volume_mm3, 0.0);
    const Contents more = brush.load(studio::light_paint(), 1.0);
    EXPECT_NEAR(more.volume_mm3, half_mm3, 1e-9 * half_mm3);
    taken += more;
    EXPECT_LT(studio::balance_error(brush.contents(), taken), 1e-14);
}

TEST(Load, NeverOverflows) {
    Brush brush(studio::flat_preset(20.0));
    brush.load(studio::dark_paint(), 1.2);
    for (int i = 0; i < 300; ++i)
        EXPECT_LE(brush.fill_of(i), brush.preset.exchange.overflow + 1e-12);
}

TEST(Load, MixesHalfAndHalfInStreaks) {
    Brush brush(studio::flat_preset(20.0));
    brush.load(MixedLoad{studio::dark_paint(), studio::light_paint(), 0.5, 0.5, false}, 1.0);
    double least = 1.0, most = 0.0;
    const double dark = studio::dark_paint()[0], light = studio::light_paint()[0];
    for (const Contents& held : brush.held) {
        const double share = (held.paint[0] / held.volume_mm3 - dark) / (light - dark);
        least = std::min(least, share);
        most = std::max(most, share);
    }
    EXPECT_LT(least, 0.25);
    EXPECT_GT(most, 0.75);
    const Contents sum = brush.contents();
    EXPECT_NEAR((sum.paint[0] / sum.volume_mm3 - dark) / (light - dark), 0.5,
                0.12);  // noise of the streaks
}

TEST(Load, PutsTwoPaintsSideBySide) {
    Brush brush(studio::flat_preset(20.0));
    brush.load(MixedLoad{studio::dark_paint(), studio::light_paint(), 0.3, 0.0, true}, 1.0);
    for (std::size_t i = 0; i < brush.held.size(); ++i) {
        const double per_mm = brush.held[i].paint[0] / brush.held[i].volume_mm3;
        const bool left = brush.tip.bristles[i].root_x_mm < 0.0F;
        EXPECT_NEAR(per_mm, left ? studio::dark_paint()[0] : studio::light_paint()[0], 1e-4);
    }
}

TEST(Load, CleaningReturnsEverything) {
    Brush brush(studio::flat_preset(20.0));
    const Contents taken = brush.load(studio::dark_paint(), 0.8);
    EXPECT_EQ(brush.clean(), taken);
    EXPECT_EQ(brush.contents(), Contents{});
}

TEST(Wick, LevelsNeighboursAndLosesNothing) {
    Brush brush(studio::flat_preset(20.0));
    Contents before =
        brush.load(MixedLoad{studio::dark_paint(), studio::light_paint(), 0.5, 0.5, true}, 1.0);
    brush.held[7] = Contents{};
    before = brush.contents();
    for (int i = 0; i < 50; ++i)
        wick_paint(brush, 1.0);
    EXPECT_LT(studio::balance_error(brush.contents(), before), 1e-13);
    EXPECT_GT(brush.fill_of(7), 0.2);
    for (const Contents& held : brush.held)
        EXPECT_GE(held.volume_mm3, 0.0);
}

/// Laid on one side: the row of hairs on that side gets the paint, the others keep what they have.
TEST(Load, DipsTheTipAlone) {
    Brush brush(studio::flat_preset(20.0));
    brush.load(studio::light_paint(), 0.5);
    const Contents base = brush.contents();
    const Contents taken = brush.load(MixedLoad{.first = studio::dark_paint(), .tip_only = true}, 1.0);
    int dipped = 0;
    double dipped_side_mm = 0.0, dry_side_mm = 0.0;
    for (int i = 0; i < 300; ++i) {
        const bool got_dark = brush.held[i].paint[0] > 1.0;
        dipped += got_dark ? 1 : 0;
        (got_dark ? dipped_side_mm : dry_side_mm) += brush.tip.bristles[i].root_y_mm;
    }
    EXPECT_EQ(dipped, 120);
    EXPECT_LT(dipped_side_mm / dipped, dry_side_mm / (300 - dipped) - 1.0);
    Contents sum = base;
    sum += taken;
    EXPECT_LT(studio::balance_error(brush.contents(), sum), 1e-14);
}

}  // namespace
}  // namespace pastoso::brush

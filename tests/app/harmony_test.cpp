#include "tools/harmony.hpp"

#include <gmock/gmock.h>

namespace pastoso::tools {
namespace {

using testing::ElementsAre;

TEST(Harmonies, LieWherePaintersPutThem) {
    EXPECT_THAT(harmony_hues(Harmony::None, 40.0), ElementsAre());
    EXPECT_THAT(harmony_hues(Harmony::Complementary, 40.0), ElementsAre(220.0));
    EXPECT_THAT(harmony_hues(Harmony::SplitComplementary, 40.0), ElementsAre(190.0, 250.0));
    EXPECT_THAT(harmony_hues(Harmony::Analogous, 40.0), ElementsAre(70.0, 10.0));
    EXPECT_THAT(harmony_hues(Harmony::Triad, 40.0), ElementsAre(160.0, 280.0));
    EXPECT_THAT(harmony_hues(Harmony::Tetrad, 40.0), ElementsAre(130.0, 220.0, 310.0));
}

TEST(Harmonies, GoRoundTheWheel) {
    EXPECT_THAT(harmony_hues(Harmony::Complementary, 180.0), ElementsAre(0.0));
    EXPECT_THAT(harmony_hues(Harmony::Tetrad, 300.0), ElementsAre(30.0, 120.0, 210.0));
}

TEST(Harmonies, HoldTheirHuesToTwoDegrees) {
    EXPECT_TRUE(in_harmony(Harmony::None, 359.0, 1.0));
    EXPECT_FALSE(in_harmony(Harmony::None, 359.0, 1.5));
    EXPECT_TRUE(in_harmony(Harmony::Triad, 40.0, 281.9));
    EXPECT_FALSE(in_harmony(Harmony::Triad, 40.0, 220.0));
}

}  // namespace
}  // namespace pastoso::tools

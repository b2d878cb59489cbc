// The mixtures that are found on a mixing well.
#include "document/puddles.hpp"

#include "core/thread_pool.hpp"
#include "document/painting.hpp"
#include "document/scenes.hpp"
#include "film/medium.hpp"

#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

const std::vector<std::string> kTubes = {"PR108", "PB29", "PW6"};

PaintRecipe mixed(double blue, double white) {
    return {{{"PB29", blue}, {"PW6", white}}, 1.0};
}

class Puddles : public testing::Test {
  protected:
    Puddles() { painting.apply(UseMedium{kMedium}); }
    void squeeze(const PaintRecipe& paint, double volume_mm3, double x_mm, double y_mm) {
        painting.apply(SqueezePaint{paint, volume_mm3, x_mm, y_mm});
    }
    std::vector<Puddle> found() {
        return puddles_on(painting.snapshot().well.value(), kTubes,
                          film::find_medium(kMedium).pigment_share);
    }

    static constexpr const char* kMedium = "heavy-body oil";
    core::ThreadPool pool{1};
    Painting painting{small_canvas(), pool};
};

TEST_F(Puddles, AMixtureIsFoundWhereItLies) {
    squeeze(mixed(62.0, 38.0), 250.0, 60.0, 45.0);
    const std::vector<Puddle> puddles = found();
    ASSERT_EQ(puddles.size(), 1U);
    EXPECT_TRUE(are_alike(puddles[0].paint, mixed(62.0, 38.0)));
    EXPECT_EQ(puddles[0].paint.ingredients[0].pigment, "PB29");
    EXPECT_NEAR(puddles[0].volume_mm3, 250.0, 1.0);
    // To the square of 2 mm.
    EXPECT_NEAR(puddles[0].x_mm, 60.0, 2.0);
    EXPECT_NEAR(puddles[0].y_mm, 45.0, 2.0);
}

TEST_F(Puddles, PaintAsItCameOutOfTheTubeIsNone) {
    squeeze({{{"PR108", 1.0}}, 1.0}, 250.0, 20.0, 20.0);
    squeeze({{{"PW6", 1.0}}, 0.5}, 250.0, 60.0, 20.0);
    EXPECT_TRUE(found().empty());
}

TEST_F(Puddles, ALittleIsNone) {
    squeeze(mixed(1.0, 1.0), 10.0, 60.0, 45.0);
    EXPECT_TRUE(found().empty());
    EXPECT_TRUE(puddles_on(painting.snapshot().well.value(), {}, 1.0).empty()) << "of no paints";
}

TEST_F(Puddles, OfSeveralTheLargestStandsFirst) {
    squeeze(mixed(20.0, 80.0), 100.0, 30.0, 30.0);
    squeeze(mixed(62.0, 38.0), 250.0, 90.0, 60.0);
    const std::vector<Puddle> puddles = found();
    ASSERT_EQ(puddles.size(), 2U);
    EXPECT_TRUE(are_alike(puddles[0].paint, mixed(62.0, 38.0)));
    EXPECT_TRUE(are_alike(puddles[1].paint, mixed(20.0, 80.0)));
    EXPECT_NEAR(puddles[1].volume_mm3, 100.0, 1.0);
    EXPECT_NEAR(puddles[1].x_mm, 30.0, 2.0);
}

TEST_F(Puddles, SqueezedOutAgainAreFoundAgain) {
    squeeze(mixed(62.0, 38.0), 250.0, 60.0, 45.0);
    const std::vector<Puddle> before = found();
    ASSERT_EQ(before.size(), 1U);
    painting.apply(CleanWell{});
    squeeze(before[0].paint, before[0].volume_mm3, before[0].x_mm, before[0].y_mm);
    const std::vector<Puddle> after = found();
    ASSERT_EQ(after.size(), 1U);
    EXPECT_TRUE(are_alike(after[0].paint, before[0].paint));
    EXPECT_NEAR(after[0].volume_mm3, before[0].volume_mm3, 1.0);
}

TEST(AlikePaints, HaveTheSameShares) {
    EXPECT_TRUE(are_alike(mixed(1.0, 1.0), mixed(50.0, 51.0)));
    EXPECT_FALSE(are_alike(mixed(1.0, 1.0), mixed(54.0, 46.0)));
    EXPECT_FALSE(are_alike(mixed(1.0, 1.0), {{{"PB29", 1.0}}, 1.0}));
    EXPECT_TRUE(are_alike({{{"PB29", 1.0}}, 1.0}, mixed(99.5, 0.5)));
}

}  // namespace
}  // namespace pastoso::document

#include "tools/mixed_paints.hpp"

#include "document/paint_mixing.hpp"

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

/// The second time from memory.
void expect_as_mixed(const document::PaintRecipe& paint, const film::Medium& medium) {
    for (int time = 0; time < 2; ++time)
        EXPECT_EQ(remembered_paint(paint, medium), document::mixed_paint(paint, medium));
}

TEST(MixedPaints, AreThoseOfTheRecipeWhateverWasMixedBefore) {
    const film::Medium& oil = film::find_medium("heavy-body oil");
    expect_as_mixed({{{"PB29", 1.0}}, 1.0}, oil);
    expect_as_mixed({{{"PB29", 1.0}}, 0.5}, oil);
    expect_as_mixed({{{"PB29", 1.0}, {"PW6", 2.0}}, 1.0}, oil);
    expect_as_mixed({{{"PB29", 2.0}, {"PW6", 1.0}}, 1.0}, oil);
    expect_as_mixed({{{"#c03020", 1.0}}, 1.0}, oil);
    expect_as_mixed({}, oil);
}

TEST(MixedPaints, AreMixedAnewInAnotherMedium) {
    const document::PaintRecipe blue{{{"PB29", 1.0}}, 1.0};
    expect_as_mixed(blue, film::find_medium("heavy-body oil"));
    expect_as_mixed(blue, film::find_medium("ink glaze"));
    film::Medium own = film::find_medium("ink glaze");
    own.viscosity_m2_s *= 2.0;
    expect_as_mixed(blue, own);
}

TEST(MixedPaints, ForgetBeforeTheyGrowTooMany) {
    const film::Medium& oil = film::find_medium("heavy-body oil");
    for (std::size_t parts = 1; parts <= 2 * kMostMixtures; ++parts)
        remembered_paint({{{"PB29", 1.0}, {"PW6", static_cast<double>(parts)}}, 1.0}, oil);
    expect_as_mixed({{{"PB29", 1.0}, {"PW6", 7.0}}, 1.0}, oil);
}

}  // namespace
}  // namespace pastoso::tools

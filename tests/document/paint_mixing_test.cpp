#include "document/paint_mixing.hpp"

#include "document/actions/actions.hpp"
#include "document/error_of.hpp"
#include "pigment/appearance.hpp"
#include "pigment/hex_colour.hpp"
#include "pigment/palette.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

pigment::Coefficients colour_of(const PaintRecipe& recipe) {
    const film::PaintCoefficients paint = mixed_paint(recipe, film::Medium{});
    pigment::Coefficients colour{};
    std::copy_n(paint.begin(), colour.size(), colour.begin());
    return colour;
}

TEST(MixedPaint, OfAColourShowsThatColour) {
    const pigment::LinearRgb shown =
        pigment::screen_colour(pigment::masstone(colour_of({{{"#c03020", 1.0}}, 1.0})));
    EXPECT_EQ(pigment::hex_colour(pigment::encoded(shown)), "#c03020");
}

TEST(MixedPaint, ColoursMixWithPigments) {
    const pigment::Coefficients red = colour_of({{{"#c03020", 1.0}}, 1.0});
    const pigment::Coefficients blue = pigment::find_pigment("PB29").coefficients;
    const pigment::Coefficients both = colour_of({{{"#c03020", 3.0}, {"PB29", 1.0}}, 0.5});
    for (int k = 0; k < pigment::kChannels; ++k)
        EXPECT_FLOAT_EQ(both[k], 0.5F * (0.75F * red[k] + 0.25F * blue[k]));
}

TEST(CheckPaint, TakesColoursAndRefusesWhatIsNone) {
    EXPECT_EQ(error_of([] { check_paint({{{"#C03020", 1.0}}, 1.0}); }), "");
    EXPECT_EQ(error_of([] {
                  check_paint({{{"#c0302", 1.0}}, 1.0});
              }),
              "\"#c0302\" is not a colour; a colour is # and six hexadecimal digits, for example "
              "#c03020.");
    EXPECT_EQ(error_of([] {
                  check_paint({{{"#c03020", 0.0}}, 1.0});
              }),
              "the number of parts of #c03020 is 0, but must lie between 1e-06 and 1e+06.");
}

}  // namespace
}  // namespace pastoso::document

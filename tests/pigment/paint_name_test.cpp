#include "pigment/paint_name.hpp"

#include "core/error.hpp"
#include "pigment/hex_colour.hpp"
#include "pigment/palette.hpp"
#include "pigment/rgb_paint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::pigment {
namespace {

using testing::HasSubstr;

std::string failure(const char* name) {
    try {
        check_paint_name(name);
    } catch (const core::InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(PaintName, IsAPigmentOrAColour) {
    EXPECT_EQ(named_paint("PB29"), find_pigment("PB29").coefficients);
    EXPECT_EQ(named_paint("#C03020"), rgb_paint(decoded({0xc0, 0x30, 0x20})).coefficients);
    EXPECT_EQ(failure("#c03020"), "no error");
    EXPECT_EQ(painters_name("PB29"), "Ultramarine blue");
    EXPECT_EQ(painters_name("#c03020"), "#c03020");
}

TEST(PaintName, ThatIsNeitherIsRefused) {
    EXPECT_THAT(failure("PB92"), HasSubstr("There is no pigment \"PB92\""));
    EXPECT_EQ(failure("#c0302"),
              "\"#c0302\" is not a colour; a colour is # and six hexadecimal digits, for example "
              "#c03020.");
    EXPECT_THROW(named_paint("#"), core::InputError);
}

}  // namespace
}  // namespace pastoso::pigment

#include "pigment/gpl.hpp"

#include "core/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::pigment {
namespace {

using testing::HasSubstr;

constexpr const char* kPortrait =
    "GIMP Palette\r\nName: Portrait\r\nColumns: 3\r\n# skin\r\n255 224 196\tLight skin\r\n"
    " 10   0 255\r\n\r\n0 0 0 Black: warm\r\n";

std::string failure(const std::string& text) {
    try {
        parse_gpl(text, "p.gpl");
    } catch (const core::InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Gpl, ReadsNamesAndColours) {
    const ColourPalette palette = parse_gpl(kPortrait, "p.gpl");
    EXPECT_EQ(palette.name, "Portrait");
    ASSERT_EQ(palette.colours.size(), 3U);
    EXPECT_EQ(palette.colours[0].name, "Light skin");
    EXPECT_EQ(palette.colours[0].colour, (Srgb8{255, 224, 196}));
    EXPECT_EQ(palette.colours[1].name, "");
    EXPECT_EQ(palette.colours[1].colour, (Srgb8{10, 0, 255}));
    EXPECT_EQ(palette.colours[2].name, "Black: warm");
}

TEST(Gpl, FindsAColourByItsName) {
    const ColourPalette palette = parse_gpl(kPortrait, "p.gpl");
    ASSERT_NE(find_colour(palette, "Light skin"), nullptr);
    EXPECT_EQ(find_colour(palette, "Light skin")->colour, (Srgb8{255, 224, 196}));
    EXPECT_EQ(find_colour(palette, "Dark skin"), nullptr);
}

TEST(Gpl, IsWrittenAsOthersReadIt) {
    const ColourPalette palette{"Sky", {{"my sky", {10, 20, 255}}, {"", {0, 0, 0}}}};
    EXPECT_EQ(gpl_text(palette), "GIMP Palette\nName: Sky\n#\n10 20 255\tmy sky\n0 0 0\t\n");
}

TEST(Gpl, ComesBackAsItWasWritten) {
    const ColourPalette palette{"My \"paints\"\n",
                                {{"8 white\n+ 1 blue", {1, 2, 3}}, {"# 2: red", {255, 0, 9}}}};
    const ColourPalette back = parse_gpl(gpl_text(palette), "p.gpl");
    EXPECT_EQ(back.name, "My \"paints\"");
    ASSERT_EQ(back.colours.size(), 2U);
    EXPECT_EQ(back.colours[0].name, "8 white + 1 blue");
    EXPECT_EQ(back.colours[0].colour, (Srgb8{1, 2, 3}));
    EXPECT_EQ(back.colours[1].name, "# 2: red");
    EXPECT_EQ(back.colours[1].colour, (Srgb8{255, 0, 9}));
}

TEST(Gpl, NamesTheLineOfAFault) {
    EXPECT_THAT(failure(""), HasSubstr("p.gpl, line 1: this is not a GIMP palette"));
    EXPECT_THAT(failure("JASC-PAL\n0100\n"), HasSubstr("p.gpl, line 1: this is not a GIMP palette"));
    EXPECT_THAT(failure("GIMP Palette\nName: x\n"), HasSubstr("p.gpl: there is no colour"));
    EXPECT_THAT(failure("GIMP Palette\n#\n300 0 0 a\n"),
                HasSubstr("p.gpl, line 3: the red \"300\" is not a whole number from 0 to 255"));
    EXPECT_THAT(failure("GIMP Palette\n0 1.5 0 a\n"), HasSubstr("line 2: the green \"1.5\" is not"));
    EXPECT_THAT(failure("GIMP Palette\n0 1 -1\n"), HasSubstr("line 2: the blue \"-1\" is not"));
    EXPECT_THAT(failure("GIMP Palette\n0 1\n"), HasSubstr("line 2: the blue is missing"));
    EXPECT_THAT(failure("GIMP Palette\n1 1 1\nName: late\n"), HasSubstr("line 3: the red \"Name:\""));
}

}  // namespace
}  // namespace pastoso::pigment

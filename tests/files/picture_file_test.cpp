#include "files/picture_file.hpp"

#include "core/text_file.hpp"
#include "document/error_of.hpp"
#include "files/image.hpp"
#include "files/png_chunks.hpp"
#include "files/temporary_folder.hpp"

#include <cmath>

#include <gmock/gmock.h>

namespace pastoso::files {
namespace {

using document::error_of;
using pigment::WorkingSpace;
using testing::HasSubstr;
using testing::Pointwise;

class PictureFileTest : public TemporaryFolder {
  protected:
    std::string bytes(const char* name) const { return core::read_text_file(folder / name); }

    std::string file(const char* name, const std::string& contents) const {
        core::write_text_file(folder / name, contents);
        return (folder / name).string();
    }
};

/// Colours inside the gamut of sRGB, in linear light.
pigment::LinearImage colours(WorkingSpace space) {
    return {2, 2, {0.8F, 0.1F, 0.05F, 0.1F, 0.6F, 0.2F, 0.02F, 0.03F, 0.5F, 1.0F, 1.0F, 1.0F}, space};
}

/// Half a step of an encoding of so many steps, in linear light where it is widest, and the profile's
/// own rounding.
float half_step(float steps) {
    return 0.5F * 2.3F / steps + 3e-4F;
}

TEST_F(PictureFileTest, WhatIsWrittenInAWorkingSpaceIsReadBackFromIt) {
    for (const WorkingSpace space : {WorkingSpace::Srgb, WorkingSpace::DisplayP3}) {
        for (const int depth : {8, 16}) {
            for (const char* name : {"a.png", "a.tif"}) {
                write_picture(folder / name, colours(space), {depth, {}});
                const pigment::LinearImage back = read_colour_image(folder / name, space);
                EXPECT_EQ(back.space, space);
                EXPECT_THAT(back.rgb, Pointwise(testing::FloatNear(half_step(depth == 8 ? 255 : 65535)),
                                                colours(space).rgb))
                    << name << " " << depth;
            }
        }
    }
}

TEST_F(PictureFileTest, JpegHoldsTheProfile) {
    pigment::LinearImage image{16, 16, {}, WorkingSpace::DisplayP3};
    for (int i = 0; i < 256; ++i)
        image.rgb.insert(image.rgb.end(), {0.6F, 0.2F, 0.1F});
    write_picture(folder / "a.jpg", image, {});
    EXPECT_THAT(bytes("a.jpg"), HasSubstr(icc_profile(WorkingSpace::DisplayP3)));
    const auto back = read_colour_image(folder / "a.jpg", WorkingSpace::DisplayP3);
    // Lossy: within two steps of 255.
    EXPECT_NEAR(back.rgb[300], 0.6F, 0.02F);
    EXPECT_NEAR(back.rgb[301], 0.2F, 0.01F);
    EXPECT_NEAR(back.rgb[302], 0.1F, 0.01F);
}

TEST_F(PictureFileTest, PngNamesItsColoursTwice) {
    write_picture(folder / "a.png", colours(WorkingSpace::Srgb), {});
    write_picture(folder / "b.png", colours(WorkingSpace::DisplayP3), {});
    using namespace std::string_literals;
    EXPECT_THAT(bytes("a.png"), HasSubstr("\0\0\0\4cICP\1\15\0\1"s));
    EXPECT_THAT(bytes("b.png"), HasSubstr("\0\0\0\4cICP\14\15\0\1"s));
    for (const char* name : {"a.png", "b.png"}) {
        EXPECT_TRUE(has_png_chunk(bytes(name), "iCCP")) << name;
        // Older ways of saying it would contradict the profile, or repeat it.
        EXPECT_FALSE(has_png_chunk(bytes(name), "gAMA")) << name;
        EXPECT_FALSE(has_png_chunk(bytes(name), "cHRM")) << name;
    }
}

TEST_F(PictureFileTest, ExrNamesItsChromaticities) {
    write_picture(folder / "a.exr", colours(WorkingSpace::DisplayP3), {});
    EXPECT_THAT(bytes("a.exr"), HasSubstr("chromaticities"));
    // Halves have 11 binary digits.
    EXPECT_THAT(read_colour_image(folder / "a.exr", WorkingSpace::DisplayP3).rgb,
                Pointwise(testing::FloatNear(5e-4F), colours(WorkingSpace::DisplayP3).rgb));
    const auto in_srgb = read_colour_image(folder / "a.exr");
    EXPECT_GT(in_srgb.rgb[0], 0.85F);
}

TEST_F(PictureFileTest, ColoursOfAProfileAreConvertedAndMarked) {
    const IccProfile p3 = icc_profile(WorkingSpace::DisplayP3);
    write_picture(folder / "a.tif", colours(WorkingSpace::Srgb), {16, p3});
    EXPECT_THAT(bytes("a.tif"), HasSubstr(p3));
    EXPECT_THAT(read_colour_image(folder / "a.tif", WorkingSpace::Srgb).rgb,
                Pointwise(testing::FloatNear(1e-3F), colours(WorkingSpace::Srgb).rgb));
    write_picture(folder / "a.png", colours(WorkingSpace::Srgb), {8, p3});
    EXPECT_TRUE(has_png_chunk(bytes("a.png"), "iCCP"));
    // The code points can name the two working spaces alone.
    EXPECT_FALSE(has_png_chunk(bytes("a.png"), "cICP"));
}

TEST_F(PictureFileTest, GreysAreReadAsColours) {
    file("grey.pgm", std::string("P5\n2 1\n255\n") + '\x80' + '\xff');
    const auto image = read_colour_image(folder / "grey.pgm");
    EXPECT_NEAR(image.rgb[0], 0.2158605, 1e-5);
    EXPECT_EQ(image.rgb[0], image.rgb[2]);
    EXPECT_NEAR(image.rgb[5], 1.0, 1e-5);
}

TEST_F(PictureFileTest, ADamagedProfileInAFileIsTold) {
    const IccProfile none(300, 'x');
    write_image(folder / "a.tif", pigment::Image8{1, 1, {1, 2, 3}}, 0.0, none);
    EXPECT_THAT(error_of([&] { read_colour_image(folder / "a.tif"); }),
                HasSubstr("a.tif: holds an ICC profile that is none ("));
    EXPECT_EQ(read_grey_image(folder / "a.tif").width, 1);
    write_image(folder / "plain.png", pigment::Image8{1, 1, {1, 2, 3}});
    std::string png = bytes("plain.png");
    png.replace(png.find("iCCP") + 60, 8, "damaged!");  // in the compressed profile
    file("a.png", png);
    EXPECT_THAT(error_of([&] { read_colour_image(folder / "a.png"); }),
                HasSubstr("a.png: holds an ICC profile that is none ("));
}

TEST_F(PictureFileTest, RefusesWhatIsNoImage) {
    EXPECT_THAT(error_of([&] { read_colour_image(file("a.png", "no picture")); }),
                HasSubstr("a.png: is not an image that can be read ("));
    EXPECT_THAT(error_of([] { read_colour_image("/nonexistent.png"); }), HasSubstr("cannot be opened"));
}

TEST_F(PictureFileTest, NamesOfColours) {
    EXPECT_EQ(picture_colours("srgb").space, WorkingSpace::Srgb);
    EXPECT_EQ(picture_colours("Display-P3").space, WorkingSpace::DisplayP3);
    const std::string path = file("p3.icc", icc_profile(WorkingSpace::DisplayP3));
    EXPECT_EQ(picture_colours(path).profile, icc_profile(WorkingSpace::DisplayP3));
    EXPECT_THAT(error_of([&] { picture_colours(file("no.icc", "text")); }),
                HasSubstr("no.icc: is no ICC profile ("));
}

TEST_F(PictureFileTest, RefusesWhatAFormatDoesNotHoldBeforeTheWork) {
    const auto path = [&](const char* name) { return (folder / name).string(); };
    EXPECT_EQ(error_of([&] {
                  check_picture_path(path("a.jpg"), {16, {}});
              }),
              path("a.jpg") + ": .jpg files do not hold 16-bit pictures.");
    EXPECT_EQ(error_of([&] {
                  check_picture_path(path("a.exr"), {8, "a profile"});
              }),
              path("a.exr") + ": this format holds linear light, which needs no ICC profile.");
    EXPECT_EQ(error_of([&] { check_picture_path(path("a.exr"), {16, {}}); }), "");
    EXPECT_EQ(error_of([&] { check_picture_path(path("a.png"), {16, {}}); }), "");
    EXPECT_EQ(files_in_folder(), 0U);
}

}  // namespace
}  // namespace pastoso::files

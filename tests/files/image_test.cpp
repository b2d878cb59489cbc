#include "files/image.hpp"

#include "core/text_file.hpp"
#include "document/error_of.hpp"
#include "files/temporary_folder.hpp"

#include <gmock/gmock.h>

namespace pastoso::files {
namespace {

using document::error_of;
using testing::HasSubstr;

class ImageTest : public TemporaryFolder {};

/// Rows of grey steps.
pigment::Image8 grey_steps() {
    pigment::Image8 image{4, 2, {}};
    for (int value : {0, 51, 102, 255, 255, 204, 153, 0}) {
        image.rgb.insert(image.rgb.end(), 3, static_cast<std::uint8_t>(value));
    }
    return image;
}
const std::vector<float> kGreySteps = {0.0F, 0.2F, 0.4F, 1.0F, 1.0F, 0.8F, 0.6F, 0.0F};

TEST_F(ImageTest, PngAndTiffKeepEightAndSixteenBits) {
    for (const char* name : {"a.png", "a.tif", "A.TIFF"}) {
        write_image(folder / name, grey_steps(), 4.0);
        const GreyImage image = read_grey_image(folder / name);
        EXPECT_EQ(image.width, 4);
        EXPECT_EQ(image.height, 2);
        // Values of 8 bits are multiples of 1/255; the weights of luminance add up to 1 but for
        // rounding.
        EXPECT_THAT(image.values, testing::Pointwise(testing::FloatNear(1e-6F), kGreySteps)) << name;
    }
    const pigment::Image16 deep{1, 1, {12345, 12345, 12345}};
    write_image(folder / "b.png", deep);
    EXPECT_NEAR(read_grey_image(folder / "b.png").values[0], 12345.0 / 65535.0, 1e-6);
}

TEST_F(ImageTest, JpegIsNear) {
    pigment::Image8 image{16, 16, std::vector<std::uint8_t>(16 * 16 * 3, 100)};
    write_image(folder / "a.jpg", image);
    // Lossy: within one step of 255.
    EXPECT_NEAR(read_grey_image(folder / "a.jpg").values[17], 100.0 / 255.0, 1.5 / 255.0);
}

TEST_F(ImageTest, ExrKeepsLinearHalves) {
    const pigment::LinearImage image{2, 1, {0.5F, 0.5F, 0.5F, 3.25F, 3.25F, 3.25F}};
    write_image(folder / "a.exr", image);
    const GreyImage back = read_grey_image(folder / "a.exr");
    EXPECT_THAT(back.values, testing::Pointwise(testing::FloatNear(1e-6F), {0.5F, 3.25F}));
}

TEST_F(ImageTest, ExrKeepsDataInSinglePrecision) {
    // Beyond the 11 bits and the largest value of halves.
    const GreyImage heights{3, 1, {0.1F, 1.0F + 0x1p-23F, 70000.0F}};
    write_image(folder / "a.exr", heights);
    EXPECT_EQ(read_grey_image(folder / "a.exr").values, heights.values);
    EXPECT_THAT(error_of([&] { write_image(folder / "a.png", heights); }),
                HasSubstr(".png files do not hold"));
}

TEST_F(ImageTest, AnExrHeaderThatReachesBeyondTheEndIsRefused) {
    write_image(folder / "a.exr", pigment::LinearImage{2, 1, {0, 0, 0, 1, 1, 1}, {}});
    std::string file = core::read_text_file(folder / "a.exr");
    const std::size_t type = file.find(std::string("chlist") + '\0');
    ASSERT_NE(type, std::string::npos);
    file[type + 10] = 0x7f;  // the highest byte of the attribute's size
    core::write_text_file(folder / "a.exr", file);
    try {
        read_grey_image(folder / "a.exr");
        FAIL();
    } catch (const core::InputError& error) {
        EXPECT_EQ(error.what(),
                  (folder / "a.exr").string() + ": is damaged (its header reaches beyond the end).");
    }
    EXPECT_THROW(read_colour_image(folder / "a.exr"), core::InputError);
}

TEST_F(ImageTest, ColourIsReadAsLuminance) {
    write_image(folder / "a.png", pigment::Image8{3, 1, {255, 0, 0, 0, 255, 0, 0, 0, 255}});
    EXPECT_THAT(read_grey_image(folder / "a.png").values,
                testing::Pointwise(testing::FloatNear(1e-6F), {0.2126F, 0.7152F, 0.0722F}));
}

TEST_F(ImageTest, TheSamePictureGivesTheSameFile) {
    write_image(folder / "a.png", grey_steps());
    write_image(folder / "b.png", grey_steps());
    EXPECT_EQ(core::read_text_file(folder / "a.png"), core::read_text_file(folder / "b.png"));
}

TEST_F(ImageTest, RefusesUnknownExtensions) {
    EXPECT_EQ(error_of([] { check_image_path("picture.xyz"); }),
              "picture.xyz: a picture is saved as .png, .tif, .jpg, .webp or .exr; this name ends in "
              "none of them.");
    EXPECT_THAT(error_of([] { check_image_path("picture"); }),
                HasSubstr("this name ends in none of them"));
}

TEST_F(ImageTest, RefusesDepthsThatAFormatDoesNotHold) {
    EXPECT_THAT(error_of([&] {
                    write_image(folder / "a.jpg", pigment::Image16{1, 1, {1, 2, 3}});
                }),
                HasSubstr("a.jpg: .jpg files do not hold 16-bit pictures."));
    EXPECT_THAT(error_of([&] { write_image(folder / "a.exr", grey_steps()); }), HasSubstr("8-bit"));
    EXPECT_THAT(error_of([&] {
                    write_image(folder / "a.png", pigment::LinearImage{1, 1, {1, 2, 3}});
                }),
                HasSubstr("linear"));
    EXPECT_EQ(files_in_folder(), 0U);
}

TEST_F(ImageTest, RefusesPlacesThatCannotBeWritten) {
    const std::string missing = (folder / "missing" / "a.png").string();
    EXPECT_EQ(error_of([&] { check_image_path(missing); }),
              missing + ": cannot be written (No such file or directory).");
    EXPECT_EQ(error_of([&] { write_image(missing, grey_steps()); }),
              missing + ": cannot be written (No such file or directory).");
    std::filesystem::create_directory(folder / "b.png");
    EXPECT_THAT(error_of([&] { check_image_path(folder / "b.png"); }),
                HasSubstr("b.png: is a folder, not a file."));
    EXPECT_THAT(error_of([] { check_image_path("/proc/a.png"); }),
                HasSubstr("/proc/a.png: cannot be written ("));
}

TEST_F(ImageTest, TheCheckLeavesNothingBehind) {
    check_image_path(folder / "a.png");
    EXPECT_EQ(files_in_folder(), 0U);
}

TEST_F(ImageTest, RefusesWhatIsNoImage) {
    EXPECT_EQ(error_of([] { read_grey_image("/nonexistent.png"); }),
              "/nonexistent.png: cannot be opened (No such file or directory).");
    core::write_text_file(folder / "a.png", "this is no picture");
    EXPECT_THAT(error_of([&] { read_grey_image(folder / "a.png"); }),
                HasSubstr("a.png: is not an image that can be read ("));
    core::write_text_file(folder / "empty.tif", "");
    EXPECT_THAT(error_of([&] { read_grey_image(folder / "empty.tif"); }),
                HasSubstr("is not an image that can be read ("));
    EXPECT_THAT(error_of([&] { read_grey_image(folder); }), HasSubstr("is a folder, not a file."));
}

TEST_F(ImageTest, RefusesTruncatedImages) {
    pigment::Image8 image{64, 64, std::vector<std::uint8_t>(64 * 64 * 3)};
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
        image.rgb[i] = static_cast<std::uint8_t>(i * i % 251);
    write_image(folder / "a.png", image);
    const std::string bytes = core::read_text_file(folder / "a.png");
    core::write_text_file(folder / "b.png", std::string_view(bytes).substr(0, bytes.size() / 2));
    EXPECT_THAT(error_of([&] { read_grey_image(folder / "b.png"); }), HasSubstr("b.png: "));
}

TEST_F(ImageTest, RefusesAbsurdSizesBeforeReadingThem) {
    std::string header = "P5\n100000 100000\n255\n";
    core::write_text_file(folder / "huge.pgm", header + "abc");
    EXPECT_THAT(error_of([&] { read_grey_image(folder / "huge.pgm"); }),
                HasSubstr("has 100000 x 100000 pixels, but at most 32768 a side"));
}

}  // namespace
}  // namespace pastoso::files

#include "core/error.hpp"
#include "core/random.hpp"
#include "core/text_file.hpp"
#include "files/image.hpp"
#include "files/image_writer.hpp"
#include "files/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::files {
namespace {

using testing::HasSubstr;

pigment::Picture noise(int width, int height) {
    pigment::Picture picture{width, height, {}};
    for (std::uint32_t i = 0; i < 4U * width * height; ++i)
        picture.rgba.push_back(static_cast<std::uint8_t>(256.0F * core::uniform_noise(i, 5)));
    return picture;
}

std::string sentence_of(const auto& work) {
    try {
        work();
    } catch (const core::InputError& error) {
        return error.what();
    }
    return "";
}

class StoredPictureTest : public TemporaryFolder {};

TEST_F(StoredPictureTest, OfAPngIsThePictureItself) {
    const pigment::Picture picture = noise(13, 7);
    core::write_text_file(folder / "a.png", png_file(picture));
    const StoredPicture stored = read_picture(folder / "a.png");
    EXPECT_EQ(stored.width_mm, 0.0);
    ASSERT_EQ(stored.picture.rgba.size(), picture.rgba.size());
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
        // Through linear light and back: a rounding of halves at most.
        EXPECT_NEAR(stored.picture.rgba[i], picture.rgba[i], i % 4 == 3 ? 0 : 1);
}

/// Red of Display P3, more or less, and a grey; as a PNG file with its profile.
std::string p3_png() {
    return png_file(
        pigment::Image8{2, 1, {200, 60, 50, 120, 120, 120}, pigment::WorkingSpace::DisplayP3});
}

TEST_F(StoredPictureTest, InMemoryHasTheColoursOfTheFile) {
    core::write_text_file(folder / "a.png", p3_png());
    const pigment::Picture picture = decode_png_to_srgb(p3_png());
    EXPECT_EQ(picture, read_picture(folder / "a.png").picture);
    EXPECT_GT(picture.rgba[0], 205);  // the same red takes more of a narrower primary
    EXPECT_EQ(decode_png(p3_png()).rgba[0], 200);
    EXPECT_NEAR(picture.rgba[4], 120, 1);
}

TEST_F(StoredPictureTest, OurOwnColoursAreTakenAsTheyAre) {
    const pigment::Picture picture = noise(13, 7);
    EXPECT_EQ(decode_png_to_srgb(png_file(picture)), picture);
}

TEST_F(StoredPictureTest, InMemoryRefusesAProfileThatIsNone) {
    std::string file = p3_png();
    const std::size_t profile = file.find("iCCP");
    ASSERT_NE(profile, std::string::npos);
    for (std::size_t i = profile + 20; i < profile + 60; ++i)
        file[i] = 'x';
    EXPECT_THAT(sentence_of([&] { decode_png_to_srgb(file); }), HasSubstr("ICC profile that is none"));
}

TEST_F(StoredPictureTest, KnowsItsSize) {
    const pigment::Image8 image{40, 20, std::vector<std::uint8_t>(std::size_t{3} * 40 * 20, 90)};
    for (const char* name : {"a.png", "a.jpg", "a.tif"}) {
        write_image(folder / name, image, 4.0);
        const StoredPicture stored = read_picture(folder / name);
        EXPECT_NEAR(stored.width_mm, 10.0, 0.1) << name;  // JPEG keeps whole pixels per inch
        EXPECT_NEAR(stored.height_mm, 5.0, 0.05) << name;
    }
}

TEST_F(StoredPictureTest, TakesTheResolutionOfScreensForNone) {
    const pigment::Image8 image{40, 20, std::vector<std::uint8_t>(std::size_t{3} * 40 * 20, 90)};
    for (const double px_per_inch : {72.0, 96.0}) {
        write_image(folder / "a.tif", image, px_per_inch / 25.4);
        EXPECT_EQ(read_picture(folder / "a.tif").width_mm, 0.0);
    }
}

TEST(PngPicture, ComesBackExactly) {
    for (const auto& [width, height] : {std::pair{1, 1}, {17, 5}, {64, 64}})
        EXPECT_EQ(decode_png(png_file(noise(width, height))), noise(width, height));
}

TEST(PngPicture, OfOtherChannelsIsSpreadOut) {
    ImageLayout grey;
    grey.width = 2;
    grey.height = 1;
    grey.channel_count = 1;
    const std::uint8_t values[] = {10, 200};
    grey.holds_colours = false;
    EXPECT_EQ(decode_png(encode_png(grey, values)),
              (pigment::Picture{2, 1, {10, 10, 10, 255, 200, 200, 200, 255}}));
}

TEST(PngPicture, ThatIsNoneIsRefused) {
    const std::string whole = png_file(noise(40, 40));
    EXPECT_THAT(sentence_of([] { decode_png("no picture"); }), HasSubstr("the picture is no PNG"));
    EXPECT_THAT(sentence_of([] { decode_png(""); }), HasSubstr("the picture is no PNG"));
    EXPECT_THAT(sentence_of([&] { decode_png(whole.substr(0, whole.size() / 2)); }),
                HasSubstr("the picture "));
}

TEST(PngPicture, ThatIsTooLargeIsRefusedBeforeItIsUnpacked) {
    std::string file = png_file(noise(4, 4));
    file[16] = 0x10;  // the width's first byte
    EXPECT_NE(sentence_of([&] { decode_png(file); }), "");
}

}  // namespace
}  // namespace pastoso::files

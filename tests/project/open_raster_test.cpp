// What other programs see of a project file.
#include "project/open_raster.hpp"

#include "core/text_file.hpp"
#include "files/image.hpp"
#include "files/temporary_folder.hpp"
#include "project/archives.hpp"
#include "project/paintings.hpp"

#include <gmock/gmock.h>

namespace pastoso::project {
namespace {

using testing::HasSubstr;

class OpenRaster : public files::TemporaryFolder {
  protected:
    pigment::LinearImage picture_in(const std::string& content) {
        core::write_text_file(folder / "picture.png", content);
        return files::read_colour_image(folder / "picture.png");
    }
    core::ThreadPool pool{2};
};

std::string text_at(std::span<const std::byte> bytes, std::size_t at, std::size_t count) {
    return {reinterpret_cast<const char*>(bytes.data()) + at, count};
}

TEST_F(OpenRaster, BeginsWithTheMimeTypeStored) {
    const auto file = file_of(busy_project(pool), folder, pool);
    EXPECT_EQ(text_at(file, 0, 4), "PK\x03\x04");
    EXPECT_EQ(text_at(file, 8, 2), std::string(2, '\0'));           // method: stored
    EXPECT_EQ(text_at(file, 26, 4), std::string("\x08\0\0\0", 4));  // lengths of name and extra field
    EXPECT_EQ(text_at(file, 30, 24), "mimetypeimage/openraster");
}

TEST_F(OpenRaster, HoldsTheEntriesOfTheSpecification) {
    const Entries entries = entries_of(file_of(busy_project(pool), folder, pool));
    const auto content = [&](const std::string& name) -> std::string {
        for (const auto& [entry, bytes] : entries)
            if (entry == name) return bytes;
        return "";
    };
    EXPECT_EQ(entries.front().first, "mimetype");
    EXPECT_THAT(content("stack.xml"),
                HasSubstr("<image version=\"0.0.3\" w=\"180\" h=\"90\" xres=\"76\" "));
    EXPECT_THAT(content("stack.xml"), HasSubstr("src=\"data/layer0.png\""));
    EXPECT_EQ(content("data/layer0.png"), content("mergedimage.png"));
    const pigment::LinearImage merged = picture_in(content("mergedimage.png"));
    EXPECT_EQ(merged.width, 180);
    EXPECT_EQ(merged.height, 90);
    const pigment::LinearImage thumbnail = picture_in(content("Thumbnails/thumbnail.png"));
    EXPECT_EQ(thumbnail.width, 180);
}

TEST_F(OpenRaster, AThumbnailIsTheMeanOfThePixelsBelow) {
    pigment::LinearImage picture{512, 256, std::vector<float>(3 * 512 * 256), {}};
    for (int i = 0; i < 512 * 256; ++i)
        picture.rgb[3 * i] = i % 2 == 0 ? 1.0F : 0.0F;
    const pigment::LinearImage small = thumbnail_of(picture);
    EXPECT_EQ(small.width, 256);
    EXPECT_EQ(small.height, 128);
    for (std::size_t i = 0; i < small.rgb.size(); i += 3)
        ASSERT_EQ(small.rgb[i], 0.5F);
}

TEST_F(OpenRaster, AThumbnailIsNeverLargerThanThePicture) {
    const pigment::LinearImage picture{40, 30, std::vector<float>(3 * 40 * 30, 0.25F), {}};
    EXPECT_EQ(thumbnail_of(picture, 64).width, 40);
    EXPECT_EQ(thumbnail_of(picture, 20).width, 20);
    EXPECT_EQ(thumbnail_of(picture, 20).height, 15);
}

TEST_F(OpenRaster, AThumbnailOfAnOddSizeKeepsEvenColours) {
    const pigment::LinearImage picture{701, 3, std::vector<float>(3 * 701 * 3, 0.25F), {}};
    const pigment::LinearImage small = thumbnail_of(picture);
    EXPECT_EQ(small.width, 256);
    EXPECT_EQ(small.height, 1);
    for (const float value : small.rgb)
        ASSERT_NEAR(value, 0.25F, 1e-6F);  // rounding of a mean of floats
}

TEST(StackXml, EscapesANameThatAPainterGave) {
    EXPECT_THAT(stack_xml(10, 10, 4.0, {{"a<b & \"c\"", "x.png"}}),
                HasSubstr("name=\"a&lt;b &amp; &quot;c&quot;\""));
}

}  // namespace
}  // namespace pastoso::project

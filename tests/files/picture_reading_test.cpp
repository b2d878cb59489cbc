// Pictures as they come: of all formats that are read, under wrong names, cut off, too large, and what
// is no picture at all.
#include "core/error.hpp"
#include "core/memory.hpp"
#include "core/text_file.hpp"
#include "document/error_of.hpp"
#include "files/image.hpp"
#include "files/png_chunks.hpp"
#include "files/temporary_folder.hpp"

#include <cmath>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

namespace pastoso::files {
namespace {

using document::error_of;
using testing::AnyOf;
using testing::HasSubstr;

struct Stored {
    const char* format;  ///< OpenImageIO's name
    const char* name;
    int channels;
    const char* compression;
};

constexpr int kWidth = 60, kHeight = 40;

constexpr Stored kStored[] = {
    {"png", "a.png", 4, ""},        {"jpeg", "a.jpg", 3, ""},        {"tiff", "a.tif", 3, "zip"},
    {"tiff", "b.tif", 4, "none"},   {"tiff", "c.tif", 3, "lzw"},     {"webp", "a.webp", 3, ""},
    {"openexr", "a.exr", 3, "zip"}, {"openexr", "b.exr", 3, "none"}, {"hdr", "a.hdr", 3, ""},
    {"bmp", "a.bmp", 3, ""},        {"targa", "a.tga", 4, ""},       {"targa", "b.tga", 4, "rle"},
    {"gif", "a.gif", 3, ""},        {"pnm", "a.ppm", 3, ""},         {"pnm", "b.pgm", 1, ""}};

/// Slow waves and a little noise: no format stores it in next to nothing.
std::vector<float> waves(int channels) {
    std::vector<float> values(static_cast<std::size_t>(kWidth) * kHeight * channels, 1.0F);
    std::uint32_t noise = 1;
    for (std::size_t i = 0; i < values.size(); ++i) {
        noise = noise * 1664525U + 1013904223U;
        const bool is_alpha = channels == 4 && i % 4 == 3;
        if (!is_alpha)
            values[i] = 0.5F + 0.3F * std::sin(static_cast<float>(i) * 0.01F) +
                        static_cast<float>(noise >> 24U) / 255.0F * 0.2F;
    }
    return values;
}

class PictureReadingTest : public TemporaryFolder {
  protected:
    std::string write(const Stored& stored) const {
        const std::string path = (folder / stored.name).string();
        const bool floats =
            std::string(stored.format) == "openexr" || std::string(stored.format) == "hdr";
        OIIO::ImageSpec spec(kWidth, kHeight, stored.channels,
                             floats ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
        if (*stored.compression != '\0') spec.attribute("compression", stored.compression);
        const auto output = OIIO::ImageOutput::create(stored.format);
        const std::vector<float> values = waves(stored.channels);
        EXPECT_TRUE(output->open(path, spec)) << output->geterror();
        EXPECT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
        EXPECT_TRUE(output->close());
        return path;
    }

    std::string file(const std::string& name, std::string_view bytes) const {
        core::write_text_file(folder / name, bytes);
        return (folder / name).string();
    }
};

TEST_F(PictureReadingTest, EachFormatIsReadUnderAnyName) {
    for (const Stored& stored : kStored) {
        const std::string bytes = core::read_text_file(write(stored));
        for (const char* name : {"x.png", "x.jpg", "x.exr", "x.mov", "no ending"}) {
            const GreyImage image = read_grey_image(file(name, bytes));
            EXPECT_EQ(image.width, kWidth) << stored.name << " as " << name;
            EXPECT_EQ(image.height, kHeight) << stored.name << " as " << name;
            // Of the noise at most, and what lossy formats make of it; linear formats as they are.
            EXPECT_NEAR(image.values[0], 0.6F, 0.2F) << stored.name << " as " << name;
        }
    }
}

TEST_F(PictureReadingTest, ReadingTakesNoMoreThanThePicture) {
    for (const Stored& stored : kStored)
        EXPECT_EQ(read_picture(write(stored)).picture.rgba.size(), 4U * kWidth * kHeight) << stored.name;
}

TEST_F(PictureReadingTest, CutOffOnesAreRefused) {
    for (const Stored& stored : kStored) {
        const std::string whole = core::read_text_file(write(stored));
        // Targa's last 26 bytes, of 26 + 495, are notes after the picture.
        const bool is_targa = std::string(stored.format) == "targa";
        const double most = is_targa ? 0.94 : 0.999;
        for (const double share : {0.0, 0.01, 0.3, 0.7, 0.8, 0.9, most}) {
            const auto bytes = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
            const std::string cut = file("cut", std::string_view(whole).substr(0, bytes));
            for (const std::string& sentence :
                 {error_of([&] { read_grey_image(cut); }), error_of([&] { read_picture(cut); })}) {
                EXPECT_THAT(sentence, testing::StartsWith(cut + ": ")) << stored.name << " at " << share;
                EXPECT_THAT(sentence,
                            AnyOf(HasSubstr("is not an image that can be read"),
                                  HasSubstr("cannot be read to its end"), HasSubstr("is cut off"),
                                  HasSubstr("is damaged"), HasSubstr("is no PNG picture")))
                    << stored.name << " at " << share;
            }
        }
    }
}

TEST_F(PictureReadingTest, NothingIsPrintedBesideTheSentence) {
    const std::string whole = core::read_text_file(write(kStored[0]));
    testing::internal::CaptureStderr();
    for (std::size_t bytes = 8; bytes < whole.size(); bytes += 97)
        EXPECT_NE(error_of([&] { read_picture(file("cut", std::string_view(whole).substr(0, bytes))); }),
                  "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(PictureReadingTest, NoOtherFormatIsReadAndNoNameMeansAnything) {
    for (const char* name : {"foo.null?RES=3000x3000", "a.mov", "a.dpx"}) {
        EXPECT_EQ(error_of([&] { read_grey_image(folder / name); }),
                  (folder / name).string() + ": cannot be opened (No such file or directory).");
        EXPECT_EQ(error_of([&] { read_grey_image(file(name, "SDPX and so on")); }),
                  (folder / name).string() +
                      ": is not an image that can be read (it is none of PNG, JPEG, TIFF, WebP, "
                      "OpenEXR, Radiance HDR, BMP, GIF, Photoshop, PNM and Targa).");
    }
}

TEST_F(PictureReadingTest, APipeIsNoPicture) {
    const std::string pipe = (folder / "pipe.png").string();
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(error_of([&] { read_grey_image(pipe); }), pipe + ": is a named pipe, not a file.");
    EXPECT_EQ(error_of([&] { read_picture("/dev/zero"); }), "/dev/zero: is a device, not a file.");
}

/// Photoshop's own: 2 x 1 pixels of three channels, not compressed.
std::string photoshop(std::uint8_t width) {
    std::string file("8BPS\0\1\0\0\0\0\0\0\0\3\0\0\0\1\0\0\0", 21);
    file += static_cast<char>(width);
    file += std::string("\0\10\0\3\0\0\0\0\0\0\0\0\0\0\0\0\0\0", 18);
    for (const char value : {'\xff', '\0', '\0', '\xff', '\0', '\0'})
        file += value;
    return file;
}

TEST_F(PictureReadingTest, PhotoshopsFilesAreRead) {
    const pigment::Picture picture = read_picture(file("a.psd", photoshop(2))).picture;
    ASSERT_EQ(picture.width, 2);
    EXPECT_EQ(picture.rgba, (std::vector<std::uint8_t>{255, 0, 0, 255, 0, 255, 0, 255}));
    EXPECT_NE(error_of([&] { read_picture(file("b.psd", photoshop(200))); }), "");
}

/// Headers that promise more than is read, without what they promise.
TEST_F(PictureReadingTest, SizesAreToldBeforeRoomIsMade) {
    using std::string_literals::operator""s;
    const std::string many = "\xff\xff";
    const std::string bmp = "BM"s + std::string(12, '\0') +
                            "\x28\0\0\0\xff\xff\0\0\xff\xff\0\0\1\0\x18\0"s + std::string(24, '\0');
    const std::string gif = "GIF89a" + many + many + std::string(30, '\0');
    const std::string targa = "\0\0\2"s + std::string(9, '\0') + many + many + "\x18\0"s;
    const std::string webp =
        "RIFF\x40\0\0\0WEBPVP8X\x0a\0\0\0\0\0\0\0\xff\x3f\0\xff\x3f\0"s + std::string(40, '\0');
    const std::string psd =
        "8BPS\0\1\0\0\0\0\0\0\0\3\0\0\xff\xff\0\0\xff\xff\0\10\0\3"s + std::string(40, '\0');
    for (const std::string& header : {bmp, gif, targa, webp, psd}) {
        const std::string path = file("large", header);
        EXPECT_THAT(error_of([&] { read_picture(path); }),
                    HasSubstr("pixels, but at most 32768 a side and 100 million in all are read."));
    }
}

TEST_F(PictureReadingTest, AnExrOfEndlessWidthIsRefused) {
    std::string exr = core::read_text_file(write(kStored[7]));
    const std::size_t window = exr.find("dataWindow");
    ASSERT_NE(window, std::string::npos);
    const std::size_t right = window + sizeof "dataWindow" + sizeof "box2i" + 4 + 8;
    exr.replace(right, 4, std::string("\xff\xff\xff\x7f", 4));
    EXPECT_THAT(error_of([&] { read_picture(file("wide.exr", exr)); }),
                HasSubstr("has 2147483648 x 40 pixels, but at most 32768"));
}

/// A hole of 5 GiB after the end takes no room on the disk, and must take none in memory.
TEST_F(PictureReadingTest, WhatFollowsThePictureIsNotTaken) {
    for (const Stored& stored : {kStored[0], kStored[1], kStored[5]}) {
        const std::string path = write(stored);
        const std::size_t before = core::peak_memory_bytes();
        ASSERT_EQ(::truncate(path.c_str(), off_t{5} << 30), 0) << "no sparse files here";
        if (std::string(stored.format) == "webp")
            EXPECT_THAT(error_of([&] { read_picture(path); }),
                        HasSubstr("bytes that are read of a WebP"));
        else
            EXPECT_EQ(read_picture(path).picture.width, kWidth);
        EXPECT_LT(core::peak_memory_bytes() - before, std::size_t{200} << 20) << stored.name;
    }
}

TEST_F(PictureReadingTest, TheOrientationOfAPngCounts) {
    const std::string exif = std::string("MM\0*\0\0\0\10\0\1\1\22\0\3\0\0\0\1\0\6\0\0\0\0\0\0", 26);
    const std::string plain = png_file(pigment::Picture{2, 1, {1, 2, 3, 255, 4, 5, 6, 255}});
    core::write_text_file(folder / "plain.png", plain);
    EXPECT_EQ(read_picture(folder / "plain.png").picture.height, 1);
    core::write_text_file(folder / "turned.png", with_png_chunk(plain, "eXIf", exif));
    EXPECT_EQ(read_picture(folder / "turned.png").picture.height, 2);
}

}  // namespace
}  // namespace pastoso::files

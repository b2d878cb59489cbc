#include "files/png_chunks.hpp"

#include <gtest/gtest.h>

namespace pastoso::files {
namespace {

using namespace std::string_literals;

/// The smallest of PNG files: one transparent pixel.
const std::string kPixel =
    "\x89PNG\r\n\x1a\n"
    "\0\0\0\x0dIHDR\0\0\0\x01\0\0\0\x01\x08\x06\0\0\0\x1f\x15\xc4\x89"
    "\0\0\0\x0dIDAT\x78\x9c\x63\x60\x60\x60\x60\0\0\0\x05\0\x01\xa5\xf6\x45\x40"
    "\0\0\0\0IEND\xae\x42\x60\x82"s;

TEST(PngChunks, AChunkGoesBehindTheHeader) {
    const std::string file = with_png_chunk(kPixel, "gAMA", "\0\0\xb1\x8f"s);
    // The checksum is that of every PNG file with this gamma.
    EXPECT_EQ(file,
              kPixel.substr(0, 33) + "\0\0\0\x04gAMA\0\0\xb1\x8f\x0b\xfc\x61\x05"s + kPixel.substr(33));
}

TEST(PngChunks, AnEmptyChunkHasTheChecksumOfItsName) {
    const std::string file = with_png_chunk(kPixel, "IEND", "");
    EXPECT_EQ(file.substr(33, 12), "\0\0\0\0IEND\xae\x42\x60\x82"s);
}

TEST(PngChunks, FindsWhatStandsBeforeThePicture) {
    EXPECT_TRUE(has_png_chunk(kPixel, "IHDR"));
    EXPECT_TRUE(has_png_chunk(with_png_chunk(kPixel, "iCCP", "abc"), "iCCP"));
    EXPECT_FALSE(has_png_chunk(kPixel, "iCCP"));
    EXPECT_FALSE(has_png_chunk(kPixel, "IEND"));
}

TEST(PngChunks, OtherAndTornFilesHaveNone) {
    EXPECT_FALSE(is_png("GIF89a"));
    EXPECT_FALSE(has_png_chunk("", "IHDR"));
    EXPECT_FALSE(has_png_chunk(std::string_view(kPixel).substr(0, 20), "IDAT"));
    const std::string endless = kPixel.substr(0, 8) + "\xff\xff\xff\xffjunk\0\0\0\0"s;
    EXPECT_FALSE(has_png_chunk(endless, "iCCP"));
}

}  // namespace
}  // namespace pastoso::files

#include "files/upright.hpp"

#include <string>

#include <gtest/gtest.h>

namespace pastoso::files {
namespace {

/// A picture of letters, a row a line.
pigment::Picture letters(int width, int height, const std::string& text) {
    pigment::Picture picture{width, height, {}};
    for (const char letter : text)
        picture.rgba.insert(picture.rgba.end(), 4, static_cast<std::uint8_t>(letter));
    return picture;
}

TEST(Upright, TurnsAndMirrorsAsExifSays) {
    // Stored as
    //   A B C
    //   D E F
    const pigment::Picture stored = letters(3, 2, "ABCDEF");
    EXPECT_EQ(upright(stored, 1), stored);
    EXPECT_EQ(upright(stored, 2), letters(3, 2, "CBAFED"));
    EXPECT_EQ(upright(stored, 3), letters(3, 2, "FEDCBA"));
    EXPECT_EQ(upright(stored, 4), letters(3, 2, "DEFABC"));
    EXPECT_EQ(upright(stored, 5), letters(2, 3, "ADBECF"));
    EXPECT_EQ(upright(stored, 6), letters(2, 3, "DAEBFC"));
    EXPECT_EQ(upright(stored, 7), letters(2, 3, "FCEBDA"));
    EXPECT_EQ(upright(stored, 8), letters(2, 3, "CFBEAD"));
}

TEST(Upright, LeavesPicturesOfUnknownOrientations) {
    const pigment::Picture stored = letters(3, 2, "ABCDEF");
    for (const int orientation : {-1, 0, 9, 1000})
        EXPECT_EQ(upright(stored, orientation), stored);
}

}  // namespace
}  // namespace pastoso::files

#include "files/base64.hpp"

#include <gtest/gtest.h>

namespace pastoso::files {
namespace {

TEST(Base64, IsThatOfTheStandard) {
    // RFC 4648, section 10.
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, BringsAllBytesBack) {
    std::string bytes;
    for (int value = 0; value < 256; ++value) {
        bytes += static_cast<char>(value);
        EXPECT_EQ(from_base64(base64(bytes)), bytes);
    }
}

TEST(Base64, RefusesWhatItDoesNotWrite) {
    for (const char* text :
         {"Zg=", "Zg", "=", "Zg==Zg==", "Z===", "Zm9\n", "Zm 9", "Zh==", "Zm9=", "Zm9-"})
        EXPECT_FALSE(from_base64(text)) << text;
}

}  // namespace
}  // namespace pastoso::files

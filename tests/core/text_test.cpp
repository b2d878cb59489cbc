#include "core/text.hpp"

#include <gtest/gtest.h>

namespace {

TEST(LowerCase, ChangesTheLettersAToZAlone) {
    EXPECT_EQ(pastoso::core::lower_case("House PAINT [@Z] 12"), "house paint [@z] 12");
    EXPECT_EQ(pastoso::core::lower_case("\xC3\x84"), "\xC3\x84");
    EXPECT_EQ(pastoso::core::lower_case(""), "");
}

TEST(Blank, IsWhatNobodySees) {
    EXPECT_TRUE(pastoso::core::is_blank(""));
    EXPECT_TRUE(pastoso::core::is_blank(" \t "));
    EXPECT_FALSE(pastoso::core::is_blank(" a "));
}

}  // namespace

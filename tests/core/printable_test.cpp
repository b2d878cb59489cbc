#include "core/printable.hpp"

#include <gtest/gtest.h>

namespace pastoso::core {
namespace {

TEST(Printable, TextPassesAsItIs) {
    for (const char* text : {"", "a.pastoso: 3 strokes\n", "Übermalung\t–\t油絵", "\xf0\x9f\x8e\xa8"})
        EXPECT_EQ(printable(text), text);
}

TEST(Printable, ControlsAreShown) {
    EXPECT_EQ(printable("\x1b[2Ja\rb\a\x7f"), "\\x1b[2Ja\\x0db\\x07\\x7f");
    EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
    // One of ISO 6429 in UTF-8, which begins a sequence as an escape does.
    EXPECT_EQ(printable("\xc2\x9b"
                        "31m"),
              "\\xc2\\x9b31m");
}

TEST(Printable, WhatIsNoUtf8IsShown) {
    EXPECT_EQ(printable("\x9b"), "\\x9b");
    EXPECT_EQ(printable("a\xc3"), "a\\xc3");
    EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");           // a longer form than needed
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // half of a pair
    EXPECT_EQ(printable("\xff"
                        "a"),
              "\\xffa");
}

}  // namespace
}  // namespace pastoso::core

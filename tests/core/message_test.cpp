#include "core/error.hpp"

#include <string>

#include <gtest/gtest.h>

namespace pastoso::core {
namespace {

TEST(Message, PutsItsArgumentsAtTheirPlaces) {
    EXPECT_EQ(message("%1 of %2, %1 again", 3, 0.5).text(), "3 of 0.5, 3 again");
    EXPECT_EQ(message("no place").text(), "no place");
    EXPECT_TRUE(Message().empty());
    EXPECT_EQ(Message().text(), "");
}

TEST(Message, LeavesArgumentsAsTheyAre) {
    EXPECT_EQ(message("%1: %2", "a%2.png", std::string("100 %1")).text(), "a%2.png: 100 %1");
    EXPECT_EQ(Message::verbatim("%1").text(), "%1");
}

TEST(Message, IsSaidInAnotherLanguagePartByPart) {
    const Message told = message("%1: is %2, not a file.", "a folder", message("a folder"));
    const auto swedish = [](const char* pattern) {
        return std::string(pattern) == "a folder" ? std::string("en mapp")
                                                  : std::string("%2 är ingen fil: %1");
    };
    EXPECT_EQ(told.text(), "a folder: is a folder, not a file.");
    EXPECT_EQ(told.text(swedish), "en mapp är ingen fil: a folder");
}

TEST(Message, KeepsPlacesThatATranslationMadeUp) {
    EXPECT_EQ(message("%1", "a").text([](const char*) { return std::string("%1 %2 % %"); }), "a %2 % %");
}

TEST(Message, IsPartOfItsError) {
    const InputError error("%1: cannot be opened (%2).", "a.png", message("a device"));
    EXPECT_STREQ(error.what(), "a.png: cannot be opened (a device).");
    EXPECT_EQ(error.message().words(), "%1: cannot be opened (%2).");
    ASSERT_EQ(error.message().arguments().size(), 2U);
    EXPECT_TRUE(error.message().arguments()[0].is_verbatim());
    EXPECT_FALSE(error.message().arguments()[1].is_verbatim());
    const InputError copy = error;
    EXPECT_EQ(copy.message(), error.message());
}

TEST(Message, TellsTheLineOfAFile) {
    EXPECT_STREQ(located_error("a.csv", 3, "%1 is no number.", "x").what(),
                 "a.csv, line 3: x is no number.");
    EXPECT_STREQ(located_error("a.csv", 0, message("it is empty.")).what(), "a.csv: it is empty.");
}

}  // namespace
}  // namespace pastoso::core

#include "tools/brush_shelf.hpp"

#include "core/error.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(BrushShelf, TheLatestToolIsFirstAndStandsThereOnce) {
    BrushShelf shelf;
    for (const char* tool : {"a", "b", "c", "a"})
        note_recent(tool, shelf);
    EXPECT_THAT(shelf.recent, ElementsAre("a", "c", "b"));
    for (std::size_t i = 0; i < kMostRecentBrushes; ++i)
        note_recent(std::to_string(i), shelf);
    EXPECT_EQ(shelf.recent.size(), kMostRecentBrushes);
    EXPECT_EQ(shelf.recent.back(), "0");
}

TEST(BrushShelf, FavouritesComeAndGo) {
    BrushShelf shelf;
    set_favourite("a", true, shelf);
    set_favourite("b", true, shelf);
    set_favourite("a", true, shelf);
    EXPECT_THAT(shelf.favourites, ElementsAre("a", "b"));
    set_favourite("a", false, shelf);
    EXPECT_FALSE(is_favourite("a", shelf));
    EXPECT_TRUE(is_favourite("b", shelf));
}

TEST(BrushShelf, AToolKeepsItsPlaceUnderAnotherName) {
    BrushShelf shelf{{"a", "b"}, {"b", "c"}};
    rename_on_shelf("b", "d", shelf);
    EXPECT_EQ(shelf, (BrushShelf{{"a", "d"}, {"d", "c"}}));
    rename_on_shelf("d", "c", shelf);
    EXPECT_EQ(shelf, (BrushShelf{{"a", "c"}, {"c"}}));
}

TEST(BrushShelf, ATagComesWithItsFirstToolAndGoesWithItsLast) {
    BrushShelf shelf;
    EXPECT_TRUE(set_tag("a", "skies", true, shelf));
    EXPECT_TRUE(set_tag("b", "skies", true, shelf));
    EXPECT_TRUE(set_tag("b", "skies", true, shelf));
    EXPECT_TRUE(set_tag("b", "hair", true, shelf));
    ASSERT_NE(find_tag("skies", shelf), nullptr);
    EXPECT_THAT(find_tag("skies", shelf)->tools, ElementsAre("a", "b"));
    EXPECT_TRUE(set_tag("b", "hair", false, shelf));
    EXPECT_EQ(find_tag("hair", shelf), nullptr);
    EXPECT_TRUE(set_tag("a", "gone", false, shelf));
    EXPECT_FALSE(set_tag("a", " ", true, shelf));
    EXPECT_EQ(shelf.tags.size(), 1U);
}

TEST(BrushShelf, WhatIsShownIsRearrangedOnItsOwnPlaces) {
    EXPECT_THAT(rearranged({"a", "b", "c", "d"}, {"d", "b"}), ElementsAre("a", "d", "c", "b"));
    EXPECT_THAT(rearranged({"a", "b", "c"}, {"x", "c", "a"}), ElementsAre("c", "b", "a"));
    EXPECT_THAT(rearranged({"a"}, {}), ElementsAre("a"));
    BrushShelf shelf;
    for (const char* tool : {"a", "b", "c"})
        set_tag(tool, "skies", true, shelf);
    arrange_tag("skies", {"c", "a"}, shelf);
    EXPECT_THAT(find_tag("skies", shelf)->tools, ElementsAre("c", "b", "a"));
}

TEST(BrushShelf, TagsAndOrderFollowANameAndAreFoundAgain) {
    const tests::TemporaryFolder folder;
    const auto file = folder.path() / "shelf.json";
    BrushShelf shelf{{"a"}, {"b"}, {"b", "a"}};
    set_tag("a", "Himmel & hav", true, shelf);
    write_brush_shelf(shelf, file);
    EXPECT_EQ(read_brush_shelf(file), shelf);
    rename_on_shelf("a", "c", shelf);
    EXPECT_THAT(shelf.order, ElementsAre("b", "c"));
    EXPECT_THAT(shelf.tags[0].tools, ElementsAre("c"));
    core::write_text_file(file, R"({"version": 1, "favourites": ["a"], "recent": []})");
    EXPECT_EQ(read_brush_shelf(file), (BrushShelf{{"a"}, {}})) << "as it was before there were tags";
}

TEST(BrushShelf, SaysWhichTagIsWrong) {
    const tests::TemporaryFolder folder;
    const auto file = folder.path() / "shelf.json";
    const auto sentence = [&](const std::string& tags) -> std::string {
        core::write_text_file(file,
                              R"({"version": 1, "favourites": [], "recent": [], "tags": )" + tags + "}");
        try {
            read_brush_shelf(file);
        } catch (const core::InputError& error) {
            return error.what();
        }
        return {};
    };
    const std::string twice = R"([{"name": "x", "tools": ["a"]}, {"name": "x", "tools": ["b"]}])";
    EXPECT_THAT(sentence(twice), HasSubstr("\"x\" is there twice"));
    EXPECT_THAT(sentence(R"([{"name": " ", "tools": ["a"]}])"), HasSubstr("a tag needs a name"));
}

TEST(BrushShelf, IsFoundAgain) {
    const tests::TemporaryFolder folder;
    const auto file = folder.path() / "deep" / "shelf.json";
    EXPECT_EQ(read_brush_shelf(file), BrushShelf{});
    const BrushShelf shelf{{"Pensel 3", "b"}, {"b"}};
    write_brush_shelf(shelf, file);
    EXPECT_EQ(read_brush_shelf(file), shelf);
}

TEST(BrushShelf, SaysWhatIsWrongInItsFile) {
    const tests::TemporaryFolder folder;
    const auto file = folder.path() / "shelf.json";
    core::write_text_file(file, R"({"version": 1, "favourites": ["a", 3], "recent": []})");
    try {
        read_brush_shelf(file);
        FAIL();
    } catch (const core::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("shelf.json"));
        EXPECT_THAT(error.what(), HasSubstr("favourites"));
    }
}

}  // namespace
}  // namespace pastoso::tools

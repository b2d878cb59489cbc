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

#include "tools/paint_shelf.hpp"

#include "core/error.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"

#include <gmock/gmock.h>

namespace pastoso::tools {
namespace {

using testing::HasSubstr;

document::PaintRecipe tube(const std::string& pigment) {
    return {{{pigment, 1.0}}, 1.0};
}

class PaintShelfTest : public ::testing::Test {
  protected:
    std::filesystem::path file() const { return folder_.path() / "pastoso" / "paints.json"; }
    std::string fault_of(const std::string& text) {
        std::filesystem::create_directories(file().parent_path());
        core::write_text_file(file(), text);
        try {
            read_shelf(file());
        } catch (const core::InputError& error) {
            return error.what();
        }
        return "";
    }

    tests::TemporaryFolder folder_;
};

TEST_F(PaintShelfTest, ComesBackAsItWasWritten) {
    PaintShelf shelf;
    note_recent(tube("PB29"), shelf);
    note_recent({{{"PB29", 62.0}, {"PW6", 38.5}}, 0.4}, shelf);
    note_recent({}, shelf);
    keep_paint(tube("#c03020"), shelf);
    keep_mix({"my sky", {{{"PB29", 1.0}, {"PW6", 8.0}}, 0.5}}, shelf);
    shelf.aids = {Harmony::Triad, with_corner({MaskShape::Complementary, 45.0}, 1, {-0.125, 0.25})};
    shelf.opened = {"Earths", {{"Umber \"raw\"", {120, 60, 20}}, {"", {200, 150, 60}}}};
    shelf.puddles = {{{{{"PB29", 62.0}, {"PW6", 38.0}}, 1.0}, 80.5, 30.0, 20.25}};
    write_shelf(shelf, file());
    const PaintShelf back = read_shelf(file());
    EXPECT_EQ(back.recent, shelf.recent);
    EXPECT_EQ(back.kept, shelf.kept);
    EXPECT_EQ(back.mixes, shelf.mixes);
    EXPECT_EQ(back.aids, shelf.aids);
    EXPECT_EQ(back.puddles, shelf.puddles);
    EXPECT_EQ(back.opened.name, "Earths");
    ASSERT_EQ(back.opened.colours.size(), 2U);
    EXPECT_EQ(back.opened.colours[0].name, "Umber \"raw\"");
    EXPECT_EQ(back.opened.colours[1].colour, (pigment::Srgb8{200, 150, 60}));
}

TEST_F(PaintShelfTest, IsEmptyWhereThereIsNoFile) {
    const PaintShelf shelf = read_shelf(file());
    EXPECT_TRUE(shelf.recent.empty());
    EXPECT_TRUE(shelf.kept.empty());
}

TEST_F(PaintShelfTest, TheLatestStandsFirstAndTheOldestGoes) {
    PaintShelf shelf;
    for (std::size_t i = 0; i < kMostRecentPaints; ++i)
        note_recent({{{"PW6", 1.0 + static_cast<double>(i)}}, 1.0}, shelf);
    note_recent({{{"PW6", 1.0}}, 1.0}, shelf);
    EXPECT_EQ(shelf.recent.size(), kMostRecentPaints);
    EXPECT_EQ(shelf.recent.front(), tube("PW6"));
    note_recent(tube("PB29"), shelf);
    EXPECT_EQ(shelf.recent.size(), kMostRecentPaints);
    EXPECT_EQ(shelf.recent.back().ingredients[0].parts, 3.0);
}

TEST_F(PaintShelfTest, APaintIsKeptOnceWhileThereIsRoom) {
    PaintShelf shelf;
    EXPECT_TRUE(keep_paint(tube("PB29"), shelf));
    EXPECT_TRUE(keep_paint(tube("PB29"), shelf));
    EXPECT_EQ(shelf.kept.size(), 1U);
    for (std::size_t i = 1; i < kMostKeptPaints; ++i)
        EXPECT_TRUE(keep_paint({{{"PW6", static_cast<double>(i)}}, 1.0}, shelf));
    EXPECT_EQ(shelf.kept.size(), kMostKeptPaints);
    EXPECT_FALSE(keep_paint(tube("PR108"), shelf));
}

TEST_F(PaintShelfTest, MixesHaveNamesOfTheirOwn) {
    PaintShelf shelf;
    EXPECT_TRUE(keep_mix({"my sky", tube("PB29")}, shelf));
    EXPECT_TRUE(keep_mix({"my sky", tube("PW6")}, shelf));
    EXPECT_FALSE(keep_mix({" ", tube("PW6")}, shelf));
    ASSERT_EQ(shelf.mixes.size(), 2U);
    EXPECT_EQ(shelf.mixes[1].name, "my sky 2");
    EXPECT_TRUE(rename_mix(1, "my sky 2", shelf)) << "its own name is free";
    EXPECT_EQ(shelf.mixes[1].name, "my sky 2");
    EXPECT_TRUE(rename_mix(1, "my sky", shelf));
    EXPECT_EQ(shelf.mixes[1].name, "my sky 2");
    EXPECT_FALSE(rename_mix(0, "", shelf));
    EXPECT_EQ(shelf.mixes[0].name, "my sky");
    while (shelf.mixes.size() < kMostMixes)
        EXPECT_TRUE(keep_mix({"mud", tube("PBk9")}, shelf));
    EXPECT_FALSE(keep_mix({"one more", tube("PBk9")}, shelf));
}

TEST_F(PaintShelfTest, ASetIsAddedToAnotherPaintersShelf) {
    PaintShelf mine, theirs;
    note_recent(tube("PB29"), mine);
    keep_paint(tube("PR108"), mine);
    keep_mix({"my sky", tube("PB29")}, mine);
    keep_mix({"mud", tube("PBk9")}, mine);
    keep_paint(tube("PR108"), theirs);
    keep_mix({"mud", tube("PBr7")}, theirs);
    write_shelf(paint_set(mine), file());
    const PaintShelf set = read_shelf(file());
    EXPECT_TRUE(set.recent.empty()) << "what was used last is nobody else's";
    EXPECT_EQ(add_paint_set(set, theirs), 2);
    EXPECT_EQ(theirs.kept.size(), 1U);
    ASSERT_EQ(theirs.mixes.size(), 3U);
    EXPECT_EQ(theirs.mixes[1], mine.mixes[0]);
    EXPECT_EQ(theirs.mixes[2].name, "mud 2");
    EXPECT_EQ(theirs.mixes[2].paint, tube("PBk9"));
    EXPECT_EQ(add_paint_set(set, mine), 0) << "they are there already";
}

TEST_F(PaintShelfTest, FaultsAreToldWithTheirPlace) {
    const std::string name = file().string();
    EXPECT_THAT(fault_of("{\"version\": 1,\n\"recent\": [}"), HasSubstr(name + ", line 2: "));
    EXPECT_EQ(fault_of("{\"version\": 1, \"kept\": []}"), name + ": the entry \"recent\" is missing.");
    EXPECT_EQ(
        fault_of("{\"version\": 1, \"recent\": [], \"kept\": [{\"mix\": [[\"PB29\", 0]]}]}"),
        name + ", kept[0]: the number of parts of PB29 is 0, but must lie between 1e-06 and 1e+06.");
    EXPECT_THAT(fault_of("{\"version\": 1, \"recent\": [{\"mix\": [[\"PX1\", 1]]}], \"kept\": []}"),
                HasSubstr(name + ", recent[0]: "));
    const auto with = [](const char* entry) {
        return std::string("{\"version\": 1, \"recent\": [], \"kept\": [], ") + entry + "}";
    };
    EXPECT_EQ(fault_of(with("\"mixes\": [{\"name\": \"\", \"paint\": {\"mix\": []}}]")),
              name + ", mixes[0].name: a mix needs a name.");
    EXPECT_THAT(fault_of(with("\"mixes\": [{\"name\": \"a\", \"paint\": {\"mix\": [[\"PX1\", 1]]}}]")),
                HasSubstr(name + ", mixes[0].paint: "));
    EXPECT_THAT(fault_of(with("\"aids\": {\"harmony\": \"loud\", \"mask\": \"none\", \"turn_deg\": 0}")),
                HasSubstr(name + ", aids.harmony: \"loud\" is not one of none, complementary, "));
    EXPECT_EQ(fault_of(with("\"aids\": {\"harmony\": \"none\", \"mask\": \"triad\", \"turn_deg\": 0, "
                            "\"corners\": [[1, 0], [0, 1]]}")),
              name + ", aids.corners: these are no corners of that mask.");
    EXPECT_THAT(
        fault_of(with("\"puddles\": [{\"paint\": {\"mix\": [[\"PB29\", 1]]}, \"volume_mm3\": 0.5, "
                      "\"x_mm\": 1, \"y_mm\": 2}]")),
        HasSubstr(name + ", puddles[0]: the volume of the squeezed paint"));
    EXPECT_EQ(fault_of("{\"version\": 2}"), name + ", version: 2 is not between 1 and 1.");
    EXPECT_EQ(fault_of("{\"version\": 1, \"recent\": [], \"kept\": [], \"opened\": {\"name\": \"x\", "
                       "\"colours\": [[\"red\", \"x\"]]}}"),
              name + ", opened.colours[0][0]: \"red\" is not a colour such as #783c14.");
}

TEST_F(PaintShelfTest, APlaceThatCannotBeWrittenIsTold) {
    core::write_text_file(folder_.path() / "pastoso", "a file where the folder should be");
    EXPECT_THROW(write_shelf({}, file()), core::InputError);
}

}  // namespace
}  // namespace pastoso::tools

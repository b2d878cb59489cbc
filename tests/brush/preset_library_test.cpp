#include "brush/preset_library.hpp"

#include "core/error.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

using testing::HasSubstr;

class PresetLibraryTest : public testing::Test {
  protected:
    Preset own(const std::string& name) const {
        Preset preset = find_preset("flat");
        preset.name = name;
        preset.tip.width_mm = 33.0;
        return preset;
    }
    PresetLibrary library() const { return load_presets(folder.path()); }

    tests::TemporaryFolder folder;
};

TEST_F(PresetLibraryTest, HoldsTheBundledPresetsWhereThereIsNoFolder) {
    const PresetLibrary library = load_presets(folder.path() / "none");
    EXPECT_EQ(library.entries.size(), bundled_presets().size());
    EXPECT_TRUE(library.faults.empty());
    EXPECT_TRUE(std::none_of(library.entries.begin(), library.entries.end(),
                             [](const auto& entry) { return entry.own; }));
}

TEST_F(PresetLibraryTest, ReadsBackWhatWasSaved) {
    const auto file = save_preset(own("My broad flat, No. 2"), folder.path() / "brushes");
    EXPECT_EQ(file.filename(), "my-broad-flat-no-2.json");
    const PresetLibrary library = load_presets(folder.path() / "brushes");
    const auto* entry = find_entry(library, "MY BROAD FLAT, NO. 2");
    ASSERT_NE(entry, nullptr);
    EXPECT_TRUE(entry->own);
    EXPECT_EQ(entry->preset, own("My broad flat, No. 2"));
    EXPECT_EQ(library.entries.size(), bundled_presets().size() + 1);
}

TEST_F(PresetLibraryTest, OwnPresetTakesThePlaceOfABundledOne) {
    save_preset(own("Filbert 14"), folder.path());
    const PresetLibrary loaded = library();
    EXPECT_EQ(loaded.entries.size(), bundled_presets().size());
    const auto* entry = find_entry(loaded, "Filbert 14");
    ASSERT_NE(entry, nullptr);
    EXPECT_TRUE(entry->own);
    EXPECT_EQ(entry->preset.tip.width_mm, 33.0);
}

TEST_F(PresetLibraryTest, AddsWhatIsNewUnderAFreeName) {
    save_preset(own("Mine"), folder.path());
    Preset other = own("Mine");
    other.paint.film_mm = 0.7;
    Preset changed_flat = find_preset("flat");
    changed_flat.paint.film_mm = 0.7;
    const auto added =
        add_presets(library(), {own("Mine"), find_preset("flat"), changed_flat, own("new"), own("New!")},
                    folder.path());
    EXPECT_THAT(added, testing::ElementsAre("Flat bristle 20 2", "new", "New! 2"));
    EXPECT_THAT(add_presets(library(), {other}, folder.path()), testing::ElementsAre("Mine 2"));
    EXPECT_EQ(find_entry(library(), "Mine")->preset, own("Mine"));
    EXPECT_EQ(find_entry(library(), "Mine 2")->preset.paint.film_mm, 0.7);
    EXPECT_EQ(find_entry(library(), "Flat bristle 20")->preset, find_preset("flat"));
    EXPECT_TRUE(library().faults.empty());
}

TEST_F(PresetLibraryTest, AddsAllOrNone) {
    const std::string too_long(300, 'b');  // no file has such a name
    EXPECT_THROW(add_presets(library(), {own("A"), own(too_long)}, folder.path()), core::InputError);
    EXPECT_EQ(find_entry(library(), "A"), nullptr);
}

TEST_F(PresetLibraryTest, TellsFaultsAndKeepsTheRest) {
    save_preset(own("Good"), folder.path());
    core::write_text_file(folder.path() / "broken.json", "{\"version\": 2, \n \"kind\": \"broom\"}");
    core::write_text_file(folder.path() / "good-again.json", preset_to_json(own("good")));
    core::write_text_file(folder.path() / "notes.txt", "no preset");
    const PresetLibrary loaded = library();
    EXPECT_NE(find_entry(loaded, "Good"), nullptr);
    ASSERT_EQ(loaded.faults.size(), 2U);
    EXPECT_THAT(loaded.faults[0].sentence.text(), HasSubstr("broken.json: kind is \"broom\""));
    EXPECT_THAT(loaded.faults[1].sentence.text(),
                HasSubstr("good.json: name is \"Good\", which another preset"));
}

TEST_F(PresetLibraryTest, ARenamedPresetMovesToTheFileOfItsName) {
    const auto old_file = save_preset(own("Mine"), folder.path());
    const PresetLibrary before = library();
    rename_preset(before, *find_entry(before, "Mine"), "Yours");
    EXPECT_FALSE(std::filesystem::exists(old_file));
    const PresetLibrary after = library();
    EXPECT_EQ(find_entry(after, "Mine"), nullptr);
    const auto* entry = find_entry(after, "Yours");
    ASSERT_NE(entry, nullptr);
    EXPECT_EQ(entry->file, folder.path() / "yours.json");
    EXPECT_EQ(entry->preset, own("Yours"));
}

TEST_F(PresetLibraryTest, ANameThatIsTakenIsNotGivenTwice) {
    save_preset(own("Mine"), folder.path());
    core::write_text_file(folder.path() / "other-file.json", "no preset");
    const PresetLibrary loaded = library();
    const auto& mine = *find_entry(loaded, "Mine");
    for (const char* name : {"Filbert 14", "Other file", ""})
        EXPECT_THROW(rename_preset(loaded, mine, name), core::InputError) << name;
    EXPECT_EQ(library().entries.size(), loaded.entries.size());
    rename_preset(loaded, mine, "MINE");
    EXPECT_EQ(find_entry(library(), "mine")->preset.name, "MINE");
}

TEST_F(PresetLibraryTest, ADeletedPresetIsGoneAndTheBundledOneIsBack) {
    save_preset(own("Filbert 14"), folder.path());
    const PresetLibrary loaded = library();
    delete_preset(*find_entry(loaded, "Filbert 14"));
    const PresetLibrary after = library();
    EXPECT_FALSE(find_entry(after, "Filbert 14")->own);
    EXPECT_EQ(after.entries.size(), bundled_presets().size());
}

TEST_F(PresetLibraryTest, UnknownNameIsNull) {
    EXPECT_EQ(find_entry(library(), "broom"), nullptr);
}

}  // namespace
}  // namespace pastoso::brush

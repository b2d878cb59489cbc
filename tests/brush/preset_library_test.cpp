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

TEST_F(PresetLibraryTest, TellsFaultsAndKeepsTheRest) {
    save_preset(own("Good"), folder.path());
    core::write_text_file(folder.path() / "broken.json", "{\"version\": 2, \n \"kind\": \"broom\"}");
    core::write_text_file(folder.path() / "good-again.json", preset_to_json(own("good")));
    core::write_text_file(folder.path() / "notes.txt", "no preset");
    const PresetLibrary loaded = library();
    EXPECT_NE(find_entry(loaded, "Good"), nullptr);
    ASSERT_EQ(loaded.faults.size(), 2U);
    EXPECT_THAT(loaded.faults[0], HasSubstr("broken.json: kind is \"broom\""));
    EXPECT_THAT(loaded.faults[1], HasSubstr("good.json: name is \"Good\", which another preset"));
}

TEST_F(PresetLibraryTest, UnknownNameIsNull) {
    EXPECT_EQ(find_entry(library(), "broom"), nullptr);
}

}  // namespace
}  // namespace pastoso::brush

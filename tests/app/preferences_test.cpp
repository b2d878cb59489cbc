#include "tools/preferences.hpp"

#include "core/error.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

class PreferencesTest : public ::testing::Test {
  protected:
    std::filesystem::path file() const { return folder_.path() / "preferences.json"; }
    std::string fault_of(const std::string& what, const std::string& instead) {
        write_preferences({}, file());
        std::string text = core::read_text_file(file());
        const std::size_t place = text.find(what);
        EXPECT_NE(place, std::string::npos) << text;
        core::write_text_file(file(), text.replace(place, what.size(), instead));
        try {
            read_preferences(file());
        } catch (const core::InputError& error) {
            return error.what();
        }
        return "";
    }

    tests::TemporaryFolder folder_;
};

TEST_F(PreferencesTest, ComeBackAsTheyWereWritten) {
    const Preferences preferences{.theme = "light",
                                  .language = "zh_TW",
                                  .drawn_by = "opengl",
                                  .monitor = "file",
                                  .monitor_file = "/a/screen.icc",
                                  .printer_file = "/b/ink.icc",
                                  .threads = 3,
                                  .autosave_min = 15};
    write_preferences(preferences, file());
    EXPECT_EQ(read_preferences(file()), preferences);
}

TEST_F(PreferencesTest, AreTheFirstOnesWhereThereIsNoFile) {
    EXPECT_EQ(read_preferences(file()), Preferences{});
}

TEST_F(PreferencesTest, FaultsAreToldWithTheirPlace) {
    const std::string name = file().string();
    EXPECT_EQ(fault_of("\"dark\"", "\"pink\""),
              name + ", theme: \"pink\" is not one of \"dark\", \"light\".");
    EXPECT_EQ(fault_of("\"language\": \"\"", "\"language\": \"tlh\""),
              name + ", language: \"tlh\" is not one of \"\", \"en\", \"ja\", \"sv\", \"zh_TW\".");
    EXPECT_EQ(fault_of("\"drawn_by\": \"\"", "\"drawn_by\": \"ink\""),
              name + ", drawn_by: \"ink\" is not one of \"\", \"opengl\", \"processor\".");
    EXPECT_EQ(fault_of("\"monitor\": \"\"", "\"monitor\": \"best\""),
              name + ", monitor: \"best\" is not one of \"\", \"none\", \"file\".");
    EXPECT_EQ(fault_of("\"threads\": 0", "\"threads\": -1"),
              name + ", threads: -1 is not between 0 and 256.");
    EXPECT_EQ(fault_of("\"autosave_min\": 0", "\"autosave_min\": 1e9"),
              name + ", autosave_min: expected a whole number, found 1000000000.0.");
}

}  // namespace
}  // namespace pastoso::tools

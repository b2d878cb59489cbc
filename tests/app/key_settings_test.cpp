#include "tools/key_settings.hpp"

#include "core/error.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"

#include <gmock/gmock.h>

namespace pastoso::tools {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

const KeyChecks kChecks{
    .set =
        [](const std::string& name) {
            if (name != "krita") throw core::InputError("\"%1\" is no set.", name);
        },
    .key =
        [](const std::string& text) {
            if (text.size() > 8) throw core::InputError("\"%1\" is no key.", text);
        },
};

class KeySettingsTest : public ::testing::Test {
  protected:
    std::filesystem::path file() const { return folder_.path() / "config" / "keys.json"; }
    std::string fault_of(const std::string& text) const {
        std::filesystem::create_directories(file().parent_path());
        core::write_text_file(file(), text);
        try {
            read_key_settings(file(), kChecks);
        } catch (const core::InputError& error) {
            return error.what();
        }
        return "";
    }

    tests::TemporaryFolder folder_;
};

TEST_F(KeySettingsTest, ComeBackAsTheyWereWritten) {
    const KeySettings settings{
        "krita", {{"dry_now", {"F12", "Ctrl+J"}}, {"quit", {}}, {"of_a_later_version", {"Ctrl+;"}}}};
    write_key_settings(settings, file());
    EXPECT_EQ(read_key_settings(file(), kChecks), settings);
}

TEST_F(KeySettingsTest, AreNoneWhereThereIsNoFile) {
    EXPECT_EQ(read_key_settings(file(), kChecks), KeySettings{});
}

TEST_F(KeySettingsTest, FaultsAreToldWithTheirPlace) {
    EXPECT_THAT(fault_of(R"({"version": 1, "set": "vi", "own": []})"),
                EndsWith("keys.json, set: \"vi\" is no set."));
    EXPECT_THAT(fault_of(R"({"version": 1, "set": "krita", "own": [{"command": "quit", "keys":
                             ["A", "Hyper+Quit"]}]})"),
                EndsWith("own[0].keys[1]: \"Hyper+Quit\" is no key."));
    EXPECT_THAT(fault_of(R"({"version": 1, "set": "krita", "own": [{"command": "quit", "keys": ["A"]},
                             {"command": "undo", "keys": ["A"]}]})"),
                EndsWith("own[1].keys[0]: \"A\" is the key of quit already."));
    EXPECT_THAT(fault_of(R"({"version": 1, "set": "krita", "own": [{"command": "quit", "keys": []},
                             {"command": "quit", "keys": ["A"]}]})"),
                EndsWith("own[1]: \"quit\" stands here twice."));
    EXPECT_THAT(fault_of(R"({"version": 1, "set": "krita"})"), HasSubstr("own"));
    EXPECT_THAT(fault_of("keys"), HasSubstr("this is not valid JSON"));
}

}  // namespace
}  // namespace pastoso::tools

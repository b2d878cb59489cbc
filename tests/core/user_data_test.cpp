#include "core/user_data.hpp"

#include <cstdlib>
#include <optional>
#include <string>

#include <gtest/gtest.h>

namespace {

using pastoso::core::user_config_path;
using pastoso::core::user_data_path;

/// The variables as they were, afterwards.
class UserData : public testing::Test {
  protected:
    void SetUp() override {
        data_ = value_of("XDG_DATA_HOME");
        config_ = value_of("XDG_CONFIG_HOME");
        home_ = value_of("HOME");
    }
    void TearDown() override {
        set("XDG_DATA_HOME", data_);
        set("XDG_CONFIG_HOME", config_);
        set("HOME", home_);
    }
    static std::optional<std::string> value_of(const char* variable) {
        const char* value = std::getenv(variable);
        return value == nullptr ? std::nullopt : std::optional<std::string>(value);
    }
    static void set(const char* variable, const std::optional<std::string>& value) {
        if (value)
            ::setenv(variable, value->c_str(), 1);
        else
            ::unsetenv(variable);
    }

  private:
    std::optional<std::string> data_, config_, home_;
};

TEST_F(UserData, LiesWhereTheDesktopSays) {
    set("XDG_DATA_HOME", "/data");
    EXPECT_EQ(user_data_path("pigments"), "/data/pastoso/pigments");
}

TEST_F(UserData, LiesInTheHomeFolderOtherwise) {
    set("HOME", "/home/anna");
    set("XDG_DATA_HOME", std::nullopt);
    EXPECT_EQ(user_data_path("pigments"), "/home/anna/.local/share/pastoso/pigments");
    // The specification has relative paths ignored.
    set("XDG_DATA_HOME", "data");
    EXPECT_EQ(user_data_path("pigments"), "/home/anna/.local/share/pastoso/pigments");
}

TEST_F(UserData, IsNowhereWithoutAHome) {
    set("HOME", std::nullopt);
    set("XDG_DATA_HOME", "");
    EXPECT_TRUE(user_data_path("pigments").empty());
}

TEST_F(UserData, SettingsHaveAFolderOfTheirOwn) {
    set("XDG_CONFIG_HOME", "/config");
    EXPECT_EQ(user_config_path("settings.json"), "/config/pastoso/settings.json");
    set("XDG_CONFIG_HOME", std::nullopt);
    set("HOME", "/home/painter");
    EXPECT_EQ(user_config_path("settings.json"), "/home/painter/.config/pastoso/settings.json");
}

}  // namespace

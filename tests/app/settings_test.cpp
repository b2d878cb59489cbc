#include "tools/settings.hpp"

#include "core/error.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"
#include "files/json_place.hpp"

#include <gmock/gmock.h>

namespace pastoso::tools {
namespace {

using testing::HasSubstr;

class SettingsTest : public ::testing::Test {
  protected:
    std::filesystem::path file() const { return folder_.path() / "settings.json"; }
    std::string fault_of(const Settings& settings, const std::string& what, const std::string& instead) {
        write_settings(settings, file());
        std::string text = core::read_text_file(file());
        const std::size_t place = text.find(what);
        EXPECT_NE(place, std::string::npos) << text;
        core::write_text_file(file(), text.replace(place, what.size(), instead));
        try {
            read_settings(file());
        } catch (const core::InputError& error) {
            return error.what();
        }
        return "";
    }

    tests::TemporaryFolder folder_;
};

TEST_F(SettingsTest, ComeBackAsTheyWereWritten) {
    Settings settings;
    settings.steadying = {SteadyMode::String, 120.0, 7.5};
    settings.reload_each_stroke = false;
    settings.turn_with_stroke = false;
    settings.undo_memory_MiB = 2048;
    settings.light_azimuth_deg = 221.5;
    settings.light_elevation_deg = 12.25;
    settings.light_ambient = 0.5;
    settings.varnish = {shade::Finish::Satin, 0.75, 0.25};
    settings.recent_commands = {"dry_now", "of another version"};
    settings.show_start_page = false;
    settings.tour_seen = true;
    settings.medium_numbers_open = true;
    settings.brush_editor_page = 4;
    settings.window_place = "AdnQywAD";
    settings.panels = "AAAA/wAAAAD9";
    settings.panels_by_hand = true;
    write_settings(settings, file());
    EXPECT_EQ(read_settings(file()), settings);
}

TEST_F(SettingsTest, AreTheFirstOnesWhereThereIsNoFile) {
    EXPECT_EQ(read_settings(file()), Settings{});
}

TEST_F(SettingsTest, OfAnEarlierVersionKnowNoVarnish) {
    write_settings({}, file());
    files::Json json = files::parse_json(core::read_text_file(file()), "settings");
    json["light"].erase("ambient");
    json["light"].erase("varnish");
    json.erase("recent_commands");
    core::write_text_file(file(), json.dump());
    EXPECT_EQ(read_settings(file()), Settings{});
}

TEST_F(SettingsTest, FaultsAreToldWithTheirPlace) {
    const std::string name = file().string();
    EXPECT_EQ(fault_of({}, "\"off\"", "\"springs\""),
              name + ", pen.steadying.mode: \"springs\" is not one of off, time, string.");
    EXPECT_EQ(fault_of({}, "80.0", "4000"),
              name + ", pen.steadying.smoothing_ms: 4000 is not above 0 and at most 400.0.");
    EXPECT_EQ(fault_of({}, "true", "1"),
              name + ", pen.reload_each_stroke: expected true or false, found 1.");
    EXPECT_EQ(fault_of({}, "512", "5"), name + ", undo_memory_MiB: 5 is not between 64 and 65536.");
    EXPECT_EQ(fault_of({}, "36.0", "95"),
              name + ", light.elevation_deg: 95 is not between 5.0 and 90.0.");
    EXPECT_EQ(fault_of({}, "\"none\"", "\"wax\""),
              name + ", light.varnish.finish: \"wax\" is not one of none, matte, satin, gloss.");
    EXPECT_EQ(fault_of({}, "\"yellowing\": 0.0", "\"yellowing\": 2"),
              name + ", light.varnish.yellowing: 2 is not between 0.0 and 1.0.");
    EXPECT_EQ(fault_of({}, "start_page\": true", "start_page\": \"no\""),
              name + ", show_start_page: expected true or false, found \"no\".");
    EXPECT_THAT(fault_of({}, "\"window\"", "window"), HasSubstr("this is not valid JSON"));
}

TEST(Steadying, KeepsTheStrengthOfTheOtherMode) {
    Steadying steadying{SteadyMode::Time, 120.0, 7.0};
    EXPECT_EQ(stabiliser_of(steadying), (brush::Stabiliser{120.0, 0.0}));
    steadying.mode = SteadyMode::String;
    EXPECT_EQ(stabiliser_of(steadying), (brush::Stabiliser{0.0, 7.0}));
    steadying.mode = SteadyMode::Off;
    EXPECT_EQ(stabiliser_of(steadying), brush::Stabiliser{});
    EXPECT_EQ(with_stabiliser(steadying, {0.0, 3.0}), (Steadying{SteadyMode::String, 120.0, 3.0}));
    EXPECT_EQ(with_stabiliser(steadying, {50.0, 0.0}), (Steadying{SteadyMode::Time, 50.0, 7.0}));
    EXPECT_EQ(with_stabiliser(steadying, {}), steadying);
    EXPECT_EQ(with_stabiliser(steadying, {900.0, 50.0}),
              (Steadying{SteadyMode::String, kMostSmoothing_ms, kLongestString_mm}));
}

}  // namespace
}  // namespace pastoso::tools

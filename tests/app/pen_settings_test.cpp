// How pens and mouse are set up, kept between two starts.
#include "tools/pen_settings.hpp"

#include "core/error.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"

#include <gmock/gmock.h>

namespace pastoso::tools {
namespace {

using testing::Contains;
using testing::HasSubstr;

const PenDevice kPen{"Wacom Intuos S Pen", PenEnd::Tip};

bool is_command(const std::string& name) {
    return name == "undo" || name == "larger_brush" || name == "smaller_brush";
}

class PenSettingsTest : public ::testing::Test {
  protected:
    std::filesystem::path file() const { return folder_.path() / "pen.json"; }

    std::string fault_of(const std::string& what, const std::string& instead) {
        PenSettings settings;
        set_curve(kPen, ready_curve(ReadyCurve::Firm), settings);
        write_pen_settings(settings, file());
        std::string text = core::read_text_file(file());
        const std::size_t place = text.find(what);
        EXPECT_NE(place, std::string::npos) << text;
        core::write_text_file(file(), text.replace(place, what.size(), instead));
        try {
            read_pen_settings(file(), is_command);
        } catch (const core::InputError& error) {
            return error.what();
        }
        return "";
    }

    tests::TemporaryFolder folder_;
};

TEST_F(PenSettingsTest, ComeBackAsTheyWereWritten) {
    PenSettings settings;
    set_curve(kPen, ready_curve(ReadyCurve::Soft), settings);
    set_curve({kPen.name, PenEnd::Eraser}, ready_curve(ReadyCurve::Firm), settings);
    settings.mouse = {.pressure = 0.8, .by_speed = true};
    settings.eraser_tool = "Rag 35";
    settings.buttons[0] = {PenButtonDoes::MoveCanvas};
    settings.buttons[1] = {PenButtonDoes::Nothing};
    settings.buttons[2] = {PenButtonDoes::Command, "undo"};
    settings.buttons[3] = {PenButtonDoes::Nothing};
    settings.fingers_paint = true;
    write_pen_settings(settings, file());
    EXPECT_EQ(read_pen_settings(file(), is_command), settings);
    settings.eraser_tool.clear();
    write_pen_settings(settings, file());
    EXPECT_EQ(read_pen_settings(file(), is_command), settings);
}

TEST_F(PenSettingsTest, AreTheFirstOnesWhereThereIsNoFile) {
    const PenSettings settings = read_pen_settings(file(), is_command);
    EXPECT_EQ(settings, PenSettings{});
    EXPECT_EQ(mapped_pressure(settings, kPen, 0.37), 0.37);
    EXPECT_EQ(settings.mouse.pressure, 0.5);
    EXPECT_THAT(eraser_tools(), Contains(settings.eraser_tool));
}

TEST_F(PenSettingsTest, OfAProgramBeforeAreReadAndCompleted) {
    core::write_text_file(file(), R"({"version": 1, "devices": [],
        "mouse": {"pressure": 0.5, "by_speed": false}, "eraser_tool": "Eraser 15",
        "buttons": {"lower": "move_canvas", "upper": "pick_colour"}})");
    PenSettings settings;
    settings.buttons[0] = {PenButtonDoes::MoveCanvas};
    settings.buttons[1] = {PenButtonDoes::PickColour};
    EXPECT_EQ(read_pen_settings(file(), is_command), settings);
}

TEST_F(PenSettingsTest, FaultsAreToldWithTheirPlace) {
    const std::string name = file().string();
    EXPECT_EQ(fault_of("pick_paint", "dance"),
              name +
                  ", buttons.lower: \"dance\" is not one of nothing, pick_paint, pick_colour, "
                  "move_canvas, popup_palette.");
    EXPECT_EQ(fault_of("larger_brush", "fly"),
              name + ", buttons.wheel_forward.command: \"fly\" is the name of no command.");
    EXPECT_EQ(fault_of("\"pressure\": 0.5", "\"pressure\": 0.01"),
              name + ", mouse.pressure: 0.01 is not between 0.05 and 1.");
    EXPECT_EQ(fault_of("Eraser 15", "Flat bristle 20"),
              name + ", eraser_tool: \"Flat bristle 20\" is no tool that an eraser end can take.");
    EXPECT_EQ(fault_of("0.08", "0.3"),
              name + ", devices[0].curve: a pressure curve leads from 0 to 1 and never falls.");
    EXPECT_THAT(fault_of("\"tip\"", "\"foot\""), HasSubstr("\"foot\" is not one of tip"));
}

TEST(PenDevices, AreKnownWithoutTheNumberOfThisStart) {
    const auto name = [](const char* told) { return pen_device(told, PenEnd::Tip).name; };
    EXPECT_EQ(name("Wacom Bamboo Pen (0x8081e5d4)"), "Wacom Bamboo Pen");
    EXPECT_EQ(name("Wacom Bamboo Pen (0)"), "Wacom Bamboo Pen");
    EXPECT_EQ(name("Wacom Bamboo Pen"), "Wacom Bamboo Pen");
    EXPECT_EQ(name("UGEE pen (left hand)"), "UGEE pen (left hand)");
    EXPECT_EQ(name("Pen (face)"), "Pen (face)");
    EXPECT_EQ(name("Pen ()"), "Pen ()");
    EXPECT_EQ(name(" (0)"), " (0)");
    EXPECT_EQ(name(""), "");
}

TEST(PenDevices, EachHasItsOwnCurve) {
    PenSettings settings;
    set_curve(kPen, ready_curve(ReadyCurve::Soft), settings);
    EXPECT_EQ(mapped_pressure(settings, kPen, 0.5), 0.72);
    EXPECT_EQ(mapped_pressure(settings, {kPen.name, PenEnd::Eraser}, 0.5), 0.5);
    EXPECT_EQ(mapped_pressure(settings, {"Another", PenEnd::Tip}, 0.5), 0.5);
    set_curve(kPen, ready_curve(ReadyCurve::Linear), settings);
    EXPECT_TRUE(settings.curves.empty());
}

}  // namespace
}  // namespace pastoso::tools

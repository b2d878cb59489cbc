// How the painter's pens, their buttons and the mouse are set up: kept between two starts.
#pragma once

#include "tools/pressure_curve.hpp"

#include <array>
#include <compare>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace pastoso::tools {

enum class PenEnd { Tip, Eraser, Puck };

/// What is known again at the next start, and at another socket.
struct PenDevice {
    std::string name;
    PenEnd end = PenEnd::Tip;
    friend auto operator<=>(const PenDevice&, const PenDevice&) = default;
};

/// The device of that name, without the number that a driver adds for this pen and this start: "Wacom
/// Bamboo Pen (0x8081e5d4)".
PenDevice pen_device(std::string_view name, PenEnd end);

/// What a button on the pen does.
enum class PenButtonDoes { Nothing, PickPaint, PickColour, MoveCanvas, PopupPalette, Command };

struct PenAction {
    PenButtonDoes does = PenButtonDoes::Nothing;
    std::string command = {};  ///< its name, of PenButtonDoes::Command
    friend bool operator==(const PenAction&, const PenAction&) = default;
};

/// The buttons from the tip up, and the wheel of an airbrush turned by a notch, which gives commands
/// alone.
enum class PenButton { Lower, Upper, Third, WheelForward, WheelBack };
inline constexpr int kPenButtons = 5;

struct MouseSettings {
    double pressure = 0.5;  ///< 0.05 to 1
    bool by_speed = false;  ///< less the faster it goes
    friend bool operator==(const MouseSettings&, const MouseSettings&) = default;
};
inline constexpr double kLeastMousePressure = 0.05;

struct PenSettings {
    std::map<PenDevice, brush::DynamicsCurve> curves;  ///< those that the painter has changed
    MouseSettings mouse;
    std::string eraser_tool = "Eraser 15";  ///< that the eraser end takes; empty: what is in hand
    std::array<PenAction, kPenButtons> buttons{
        {{PenButtonDoes::PickPaint},
         {PenButtonDoes::PopupPalette},
         {PenButtonDoes::Nothing},
         {PenButtonDoes::Command, "larger_brush"},
         {PenButtonDoes::Command, "smaller_brush"}}};  ///< in the order of PenButton
    bool fingers_paint = false;  ///< else one finger moves the canvas, as two always do
    bool wet_mark = true;        ///< a wet mark runs ahead of the paint
    const PenAction& action(PenButton button) const { return buttons[static_cast<std::size_t>(button)]; }
    friend bool operator==(const PenSettings&, const PenSettings&) = default;
};

/// The device's own curve, or the linear one.
brush::DynamicsCurve curve_of(const PenSettings& settings, const PenDevice& device);

/// What the device tells, along its curve: all pressure of pens goes through here.
double mapped_pressure(const PenSettings& settings, const PenDevice& device, double told);

/// Keeps the curve for the device; the linear one needs no keeping.
void set_curve(const PenDevice& device, const brush::DynamicsCurve& curve, PenSettings& settings);

/// Bundled tools that the eraser end may take: those that touch the canvas and are not dipped.
std::vector<std::string> eraser_tools();

/// The settings at first where there is no such file. Throws InputError that names the file, the place
/// in it and the value for anything malformed or out of range, names of no command among it.
PenSettings read_pen_settings(const std::filesystem::path& file,
                              const std::function<bool(const std::string&)>& is_command);

/// Written aside, its folder made where there is none. Throws InputError where that cannot be written.
void write_pen_settings(const PenSettings& settings, const std::filesystem::path& file);

}  // namespace pastoso::tools

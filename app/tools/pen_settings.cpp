#include "tools/pen_settings.hpp"

#include "brush/preset_names.hpp"
#include "tools/memory_file.hpp"

#include <algorithm>

namespace pastoso::tools {
namespace {

using brush::Named;
using files::Json;
using files::JsonPlace;

constexpr int kVersion = 1;

constexpr Named<PenEnd> kEnds[] = {
    {"tip", PenEnd::Tip}, {"eraser", PenEnd::Eraser}, {"puck", PenEnd::Puck}};
constexpr Named<PenButtonDoes> kButtons[] = {{"nothing", PenButtonDoes::Nothing},
                                             {"pick_paint", PenButtonDoes::PickPaint},
                                             {"pick_colour", PenButtonDoes::PickColour},
                                             {"move_canvas", PenButtonDoes::MoveCanvas},
                                             {"popup_palette", PenButtonDoes::PopupPalette}};

/// In the order of PenButton.
constexpr const char* kButtonKeys[kPenButtons] = {"lower", "upper", "third", "wheel_forward",
                                                  "wheel_back"};

template <class T, std::size_t N>
T read_word(const JsonPlace& place, const Named<T> (&names)[N]) {
    const std::string text = place.text();
    std::string known;
    for (const Named<T>& named : names) {
        if (text == named.name) return named.value;
        known += (known.empty() ? "" : ", ") + std::string(named.name);
    }
    place.fail("\"%1\" is not one of %2.", text, known);
}

Json curve_json(const brush::DynamicsCurve& curve) {
    Json points = Json::array();
    for (const brush::CurvePoint& point : curve.points)
        points.push_back(Json::array({point.input, point.output}));
    return points;
}

brush::DynamicsCurve read_curve(const JsonPlace& place) {
    brush::DynamicsCurve curve;
    for (std::size_t i = 0; i < place.size(); ++i) {
        const JsonPlace point = place.element(i);
        if (point.size() != 2) point.fail("expected two numbers, for example [0.5, 0.7].");
        curve.points.push_back({point.element(0).number(), point.element(1).number()});
    }
    if (curve.points.size() > brush::kMostCurvePoints || !is_pressure_curve(curve.points))
        place.fail("a pressure curve leads from 0 to 1 and never falls.");
    return curve;
}

void read_devices(const JsonPlace& place, PenSettings& settings) {
    for (std::size_t i = 0; i < place.size(); ++i) {
        const JsonPlace entry = place.element(i);
        entry.allow_only({"name", "end", "curve"});
        const PenDevice device{entry.entry("name").text(), read_word(entry.entry("end"), kEnds)};
        if (!settings.curves.try_emplace(device, read_curve(entry.entry("curve"))).second)
            entry.fail("\"%1\" stands here twice.", device.name);
    }
}

MouseSettings read_mouse(const JsonPlace& place) {
    place.allow_only({"pressure", "by_speed"});
    const JsonPlace pressure = place.entry("pressure");
    if (!(pressure.number() >= kLeastMousePressure && pressure.number() <= 1.0))
        pressure.fail("%1 is not between %2 and %3.", pressure.value().dump(), Json(kLeastMousePressure).dump(), 1);
    return {pressure.number(), place.entry("by_speed").boolean()};
}

std::string read_eraser(const JsonPlace& place) {
    const std::string name = place.text();
    const std::vector<std::string> tools = eraser_tools();
    if (!name.empty() && std::find(tools.begin(), tools.end(), name) == tools.end())
        place.fail("\"%1\" is no tool that an eraser end can take.", name);
    return name;
}

/// A word, or {"command": its name}.
PenAction read_action(const JsonPlace& place,
                      const std::function<bool(const std::string&)>& is_command) {
    if (!place.value().is_object()) return {read_word(place, kButtons)};
    place.allow_only({"command"});
    const std::string name = place.entry("command").text();
    if (!is_command(name)) place.entry("command").fail("\"%1\" is the name of no command.", name);
    return {PenButtonDoes::Command, name};
}

Json action_json(const PenAction& action) {
    if (action.does == PenButtonDoes::Command) return {{"command", action.command}};
    return brush::word_for(action.does, kButtons);
}

/// Those that are not told keep what they do at first.
void read_buttons(const JsonPlace& place, const std::function<bool(const std::string&)>& is_command,
                  PenSettings& settings) {
    place.allow_only({kButtonKeys[0], kButtonKeys[1], kButtonKeys[2], kButtonKeys[3], kButtonKeys[4]});
    for (std::size_t i = 0; i < kPenButtons; ++i)
        if (const auto entry = place.optional_entry(kButtonKeys[i]))
            settings.buttons[i] = read_action(*entry, is_command);
}

/// Without " (0)", " (0x8081e5d4)" and the like at its end.
std::string_view without_serial(std::string_view name) {
    const auto open = name.rfind(" (");
    if (open == std::string_view::npos || open == 0 || name.back() != ')') return name;
    const std::string_view number = name.substr(open + 2, name.size() - open - 3);
    const bool is_number = !number.empty() && number.front() >= '0' && number.front() <= '9' &&
                           number.find_first_not_of("0123456789abcdefABCDEFx") == number.npos;
    return is_number ? name.substr(0, open) : name;
}

}  // namespace

PenDevice pen_device(std::string_view name, PenEnd end) {
    return {std::string(without_serial(name)), end};
}

brush::DynamicsCurve curve_of(const PenSettings& settings, const PenDevice& device) {
    const auto found = settings.curves.find(device);
    return found != settings.curves.end() ? found->second : ready_curve(ReadyCurve::Linear);
}

double mapped_pressure(const PenSettings& settings, const PenDevice& device, double told) {
    return mapped_pressure(curve_of(settings, device), told);
}

void set_curve(const PenDevice& device, const brush::DynamicsCurve& curve, PenSettings& settings) {
    if (curve == ready_curve(ReadyCurve::Linear))
        settings.curves.erase(device);
    else
        settings.curves.insert_or_assign(device, curve);
}

std::vector<std::string> eraser_tools() {
    std::vector<std::string> names;
    for (const brush::Preset& preset : brush::bundled_presets())
        if (preset.kind == brush::ToolKind::Contact && !preset.dips) names.push_back(preset.name);
    return names;
}

PenSettings read_pen_settings(const std::filesystem::path& file,
                              const std::function<bool(const std::string&)>& is_command) {
    PenSettings settings;
    read_memory(file, kVersion, [&](const JsonPlace& root) {
        root.allow_only(
            {"version", "devices", "mouse", "eraser_tool", "buttons", "fingers_paint", "wet_mark"});
        read_devices(root.entry("devices"), settings);
        settings.mouse = read_mouse(root.entry("mouse"));
        settings.eraser_tool = read_eraser(root.entry("eraser_tool"));
        read_buttons(root.entry("buttons"), is_command, settings);
        settings.fingers_paint = root.boolean_or("fingers_paint", settings.fingers_paint);
        settings.wet_mark = root.boolean_or("wet_mark", settings.wet_mark);
    });
    return settings;
}

void write_pen_settings(const PenSettings& settings, const std::filesystem::path& file) {
    Json devices = Json::array(), buttons = Json::object();
    for (std::size_t i = 0; i < kPenButtons; ++i)
        buttons[kButtonKeys[i]] = action_json(settings.buttons[i]);
    for (const auto& [device, curve] : settings.curves)
        devices.push_back({{"name", device.name},
                           {"end", brush::word_for(device.end, kEnds)},
                           {"curve", curve_json(curve)}});
    write_memory(
        {{"version", kVersion},
         {"devices", std::move(devices)},
         {"mouse", {{"pressure", settings.mouse.pressure}, {"by_speed", settings.mouse.by_speed}}},
         {"eraser_tool", settings.eraser_tool},
         {"fingers_paint", settings.fingers_paint},
         {"wet_mark", settings.wet_mark},
         {"buttons", std::move(buttons)}},
        file);
}

}  // namespace pastoso::tools

#include "tools/settings.hpp"

#include "tools/memory_file.hpp"

namespace pastoso::tools {
namespace {

using io::Json;
using io::JsonPlace;

constexpr int kVersion = 1;

struct NamedMode {
    const char* name;
    SteadyMode mode;
};
constexpr NamedMode kModes[] = {
    {"off", SteadyMode::Off}, {"time", SteadyMode::Time}, {"string", SteadyMode::String}};

const char* name_of(SteadyMode mode) {
    for (const NamedMode& named : kModes)
        if (named.mode == mode) return named.name;
    return kModes[0].name;
}

SteadyMode read_mode(const JsonPlace& place) {
    const std::string text = place.text();
    for (const NamedMode& named : kModes)
        if (text == named.name) return named.mode;
    place.fail("\"" + text + "\" is not one of off, time and string.");
}

double read_strength(const JsonPlace& place, double most) {
    const double strength = place.number();
    if (!(strength > 0.0 && strength <= most))
        place.fail(place.value().dump() + " is not above 0 and at most " + Json(most).dump() + ".");
    return strength;
}

double read_angle(const JsonPlace& place, double least, double most) {
    const double angle = place.number();
    if (!(angle >= least && angle <= most))
        place.fail(place.value().dump() + " is not between " + Json(least).dump() + " and " +
                   Json(most).dump() + ".");
    return angle;
}

Json steadying_json(const Steadying& steadying) {
    return {{"mode", name_of(steadying.mode)},
            {"smoothing_ms", steadying.smoothing_ms},
            {"string_mm", steadying.string_mm}};
}

Steadying read_steadying(const JsonPlace& place) {
    place.allow_only({"mode", "smoothing_ms", "string_mm"});
    return {read_mode(place.entry("mode")),
            read_strength(place.entry("smoothing_ms"), kMostSmoothing_ms),
            read_strength(place.entry("string_mm"), kLongestString_mm)};
}

}  // namespace

Settings read_settings(const std::filesystem::path& file) {
    Settings settings;
    read_memory(file, kVersion, [&](const JsonPlace& root) {
        root.allow_only({"version", "pen", "window", "undo_memory_MiB", "light", "show_start_page"});
        if (const auto light = root.optional_entry("light")) {
            light->allow_only({"azimuth_deg", "elevation_deg"});
            settings.light_azimuth_deg = read_angle(light->entry("azimuth_deg"), 0.0, 360.0);
            settings.light_elevation_deg = read_angle(light->entry("elevation_deg"), 5.0, 90.0);
        }
        if (const auto memory = root.optional_entry("undo_memory_MiB"))
            settings.undo_memory_MiB =
                static_cast<int>(memory->integer(kLeastUndoMemory_MiB, kMostUndoMemory_MiB));
        if (const auto shown = root.optional_entry("show_start_page"))
            settings.show_start_page = shown->boolean();
        const JsonPlace pen = root.entry("pen"), window = root.entry("window");
        pen.allow_only({"steadying", "reload_each_stroke", "turn_with_stroke"});
        window.allow_only({"place", "panels"});
        settings.steadying = read_steadying(pen.entry("steadying"));
        settings.reload_each_stroke = pen.entry("reload_each_stroke").boolean();
        settings.turn_with_stroke = pen.entry("turn_with_stroke").boolean();
        settings.window_place = window.entry("place").text();
        settings.panels = window.entry("panels").text();
    });
    return settings;
}

void write_settings(const Settings& settings, const std::filesystem::path& file) {
    write_memory({{"version", kVersion},
                  {"pen",
                   {{"steadying", steadying_json(settings.steadying)},
                    {"reload_each_stroke", settings.reload_each_stroke},
                    {"turn_with_stroke", settings.turn_with_stroke}}},
                  {"show_start_page", settings.show_start_page},
                  {"undo_memory_MiB", settings.undo_memory_MiB},
                  {"light",
                   {{"azimuth_deg", settings.light_azimuth_deg},
                    {"elevation_deg", settings.light_elevation_deg}}},
                  {"window", {{"place", settings.window_place}, {"panels", settings.panels}}}},
                 file);
}

}  // namespace pastoso::tools

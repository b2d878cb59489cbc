#include "tools/settings.hpp"

#include "tools/memory_file.hpp"

#include <cstddef>

namespace pastoso::tools {
namespace {

using files::Json;
using files::JsonPlace;

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
    place.fail("\"%1\" is not one of %2.", text, "off, time, string");
}

double read_strength(const JsonPlace& place, double most) {
    const double strength = place.number();
    if (!(strength > 0.0 && strength <= most))
        place.fail("%1 is not above 0 and at most %2.", place.value().dump(), Json(most).dump());
    return strength;
}

double read_number(const JsonPlace& place, double least, double most) {
    const double number = place.number();
    if (!(number >= least && number <= most))
        place.fail("%1 is not between %2 and %3.", place.value().dump(), Json(least).dump(),
                   Json(most).dump());
    return number;
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

std::vector<std::string> read_texts(const JsonPlace& place) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < place.size(); ++i)
        texts.push_back(place.element(i).text());
    return texts;
}

struct NamedFinish {
    const char* name;
    shade::Finish finish;
};
constexpr NamedFinish kFinishes[] = {{"none", shade::Finish::None},
                                     {"matte", shade::Finish::Matte},
                                     {"satin", shade::Finish::Satin},
                                     {"gloss", shade::Finish::Gloss}};

const char* name_of(shade::Finish finish) {
    for (const NamedFinish& named : kFinishes)
        if (named.finish == finish) return named.name;
    return kFinishes[0].name;
}

shade::Finish read_finish(const JsonPlace& place) {
    const std::string text = place.text();
    for (const NamedFinish& named : kFinishes)
        if (text == named.name) return named.finish;
    place.fail("\"%1\" is not one of %2.", text, "none, matte, satin, gloss");
}

Json varnish_json(const shade::Varnish& varnish) {
    return {{"finish", name_of(varnish.finish)},
            {"amount", varnish.amount},
            {"yellowing", varnish.yellowing}};
}

shade::Varnish read_varnish(const JsonPlace& place) {
    place.allow_only({"finish", "amount", "yellowing"});
    return {read_finish(place.entry("finish")), read_number(place.entry("amount"), 0.0, 1.0),
            read_number(place.entry("yellowing"), 0.0, 1.0)};
}

}  // namespace

Settings read_settings(const std::filesystem::path& file) {
    Settings settings;
    read_memory(file, kVersion, [&](const JsonPlace& root) {
        root.allow_only({"version", "pen", "window", "undo_memory_MiB", "light", "recent_commands",
                         "show_start_page", "tour_seen", "medium_numbers_open", "brush_editor_page"});
        if (const auto recent = root.optional_entry("recent_commands"))
            settings.recent_commands = read_texts(*recent);
        if (const auto light = root.optional_entry("light")) {
            light->allow_only({"azimuth_deg", "elevation_deg", "ambient", "varnish"});
            settings.light_azimuth_deg = read_number(light->entry("azimuth_deg"), 0.0, 360.0);
            settings.light_elevation_deg = read_number(light->entry("elevation_deg"), 5.0, 90.0);
            if (const auto ambient = light->optional_entry("ambient"))
                settings.light_ambient = read_number(*ambient, 0.0, 1.0);
            if (const auto varnish = light->optional_entry("varnish"))
                settings.varnish = read_varnish(*varnish);
        }
        if (const auto memory = root.optional_entry("undo_memory_MiB"))
            settings.undo_memory_MiB =
                static_cast<int>(memory->integer(kLeastUndoMemory_MiB, kMostUndoMemory_MiB));
        if (const auto shown = root.optional_entry("show_start_page"))
            settings.show_start_page = shown->boolean();
        if (const auto seen = root.optional_entry("tour_seen")) settings.tour_seen = seen->boolean();
        if (const auto open = root.optional_entry("medium_numbers_open"))
            settings.medium_numbers_open = open->boolean();
        if (const auto page = root.optional_entry("brush_editor_page"))
            settings.brush_editor_page = static_cast<int>(page->integer(0, kMostBrushEditorPage));
        const JsonPlace pen = root.entry("pen"), window = root.entry("window");
        pen.allow_only({"steadying", "reload_each_stroke", "turn_with_stroke"});
        window.allow_only({"place", "panels", "panels_by_hand"});
        settings.steadying = read_steadying(pen.entry("steadying"));
        settings.reload_each_stroke = pen.entry("reload_each_stroke").boolean();
        settings.turn_with_stroke = pen.entry("turn_with_stroke").boolean();
        settings.window_place = window.entry("place").text();
        settings.panels = window.entry("panels").text();
        if (const auto by_hand = window.optional_entry("panels_by_hand"))
            settings.panels_by_hand = by_hand->boolean();
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
                  {"tour_seen", settings.tour_seen},
                  {"medium_numbers_open", settings.medium_numbers_open},
                  {"brush_editor_page", settings.brush_editor_page},
                  {"undo_memory_MiB", settings.undo_memory_MiB},
                  {"light",
                   {{"azimuth_deg", settings.light_azimuth_deg},
                    {"elevation_deg", settings.light_elevation_deg},
                    {"ambient", settings.light_ambient},
                    {"varnish", varnish_json(settings.varnish)}}},
                  {"recent_commands", settings.recent_commands},
                  {"window",
                   {{"place", settings.window_place},
                    {"panels", settings.panels},
                    {"panels_by_hand", settings.panels_by_hand}}}},
                 file);
}

}  // namespace pastoso::tools

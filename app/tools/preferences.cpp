#include "tools/preferences.hpp"

#include "tools/memory_file.hpp"

#include <algorithm>
#include <initializer_list>

namespace pastoso::tools {
namespace {

using files::Json;
using files::JsonPlace;

constexpr int kVersion = 1;

std::string read_one_of(const JsonPlace& place, std::initializer_list<const char*> known) {
    const std::string text = place.text();
    if (std::find(known.begin(), known.end(), text) != known.end()) return text;
    std::string all;
    for (const char* name : known)
        all += std::string(all.empty() ? "\"" : ", \"") + name + "\"";
    place.fail("\"%1\" is not one of %2.", text, all);
}

}  // namespace

Preferences read_preferences(const std::filesystem::path& file) {
    Preferences preferences;
    read_memory(file, kVersion, [&](const JsonPlace& root) {
        root.allow_only({"version", "theme", "language", "drawn_by", "monitor", "monitor_file",
                         "printer_file", "threads", "autosave_min"});
        preferences.theme = read_one_of(root.entry("theme"), {"dark", "light"});
        preferences.language = read_one_of(root.entry("language"), {"", "en", "ja", "sv", "zh_TW"});
        if (const auto drawn_by = root.optional_entry("drawn_by"))
            preferences.drawn_by = read_one_of(*drawn_by, {"", "opengl", "processor"});
        if (const auto monitor = root.optional_entry("monitor"))
            preferences.monitor = read_one_of(*monitor, {"", "none", "file"});
        if (const auto path = root.optional_entry("monitor_file"))
            preferences.monitor_file = path->text();
        if (const auto path = root.optional_entry("printer_file"))
            preferences.printer_file = path->text();
        preferences.threads = static_cast<int>(root.entry("threads").integer(0, kMostThreads));
        preferences.autosave_min =
            static_cast<int>(root.entry("autosave_min").integer(0, kMostAutosave_min));
    });
    return preferences;
}

void write_preferences(const Preferences& preferences, const std::filesystem::path& file) {
    write_memory({{"version", kVersion},
                  {"theme", preferences.theme},
                  {"language", preferences.language},
                  {"drawn_by", preferences.drawn_by},
                  {"monitor", preferences.monitor},
                  {"monitor_file", preferences.monitor_file},
                  {"printer_file", preferences.printer_file},
                  {"threads", preferences.threads},
                  {"autosave_min", preferences.autosave_min}},
                 file);
}

}  // namespace pastoso::tools

// What the painter has set the program up with in its settings: kept between two starts, and known
// before there is a window.
#pragma once

#include <filesystem>
#include <string>

namespace pastoso::tools {

inline constexpr int kMostThreads = 256, kMostAutosave_min = 240;

struct Preferences {
    std::string theme = "dark";  ///< or "light"
    std::string language;        ///< "en", "ja", "sv" or "zh_TW"; empty: that of the desktop
    std::string drawn_by;        ///< the canvas: "opengl" or "processor"; empty: what is faster
    std::string monitor;         ///< whose profile: "none" or "file"; empty: as the system has it
    std::string monitor_file;    ///< of "file"
    std::string printer_file;    ///< the profile of a printer; empty: none
    int threads = 0;             ///< 0 to kMostThreads; 0: one for each processor
    int autosave_min = 0;        ///< minutes between two, 0 to kMostAutosave_min; 0: never
    friend bool operator==(const Preferences&, const Preferences&) = default;
};

/// Those at first where there is no such file. Throws InputError that names the file, the place in it
/// and the value for anything malformed or out of range.
Preferences read_preferences(const std::filesystem::path& file);

/// Written aside, its folder made where there is none. Throws InputError where that cannot be written.
void write_preferences(const Preferences& preferences, const std::filesystem::path& file);

}  // namespace pastoso::tools

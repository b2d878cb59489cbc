// How the painter likes the window and the pen: kept between two starts.
#pragma once

#include "shade/varnish.hpp"
#include "tools/steadying.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace pastoso::tools {

/// Memory for the steps that Undo returns to: at first, and what can be chosen.
inline constexpr int kUndoMemory_MiB = 512, kLeastUndoMemory_MiB = 64, kMostUndoMemory_MiB = 65536;

inline constexpr int kMostBrushEditorPage = 20;

struct Settings {
    Steadying steadying;
    bool reload_each_stroke = true;
    bool turn_with_stroke = true;
    int undo_memory_MiB = kUndoMemory_MiB;     ///< kLeast to kMostUndoMemory_MiB
    double light_azimuth_deg = 135.0;          ///< 0 to 360: 0 right, 90 top
    double light_elevation_deg = 36.0;         ///< 5 to 90
    double light_ambient = 0.30;               ///< shade::Lighting, 0 to 1
    shade::Varnish varnish;                    ///< that the painting is seen under
    std::vector<std::string> recent_commands;  ///< of the palette, by name, the latest first
    bool show_start_page = true;               ///< when the program starts without a file
    bool tour_seen = false;                    ///< or left
    bool medium_numbers_open = false;          ///< those below the words for a medium
    int brush_editor_page = 0;                 ///< the one that was open last, 0 to kMostBrushEditorPage
    std::string window_place;                  ///< as Qt writes it, in base 64; empty: nothing is known
    std::string panels;  ///< the same: which stand where, how large, and which are open
    bool panels_by_hand = false;  ///< their heights are the painter's own
    friend bool operator==(const Settings&, const Settings&) = default;
};

/// The settings at first where there is no such file. Throws InputError that names the file, the place
/// in it and the value for anything malformed or out of range.
Settings read_settings(const std::filesystem::path& file);

/// Written aside, its folder made where there is none. Throws InputError where that cannot be written.
void write_settings(const Settings& settings, const std::filesystem::path& file);

}  // namespace pastoso::tools

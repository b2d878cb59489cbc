// The tools that a painter finds again at once: favourites, and those used last.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace pastoso::tools {

inline constexpr std::size_t kMostRecentBrushes = 12;

struct BrushShelf {
    std::vector<std::string> favourites;  ///< names of tools, each once, in the order they were chosen
    std::vector<std::string> recent;      ///< the latest first, at most kMostRecentBrushes
    friend bool operator==(const BrushShelf&, const BrushShelf&) = default;
};

bool is_favourite(const std::string& tool, const BrushShelf& shelf);
void set_favourite(const std::string& tool, bool favourite, BrushShelf& shelf);

/// Puts the tool first among the recent ones.
void note_recent(const std::string& tool, BrushShelf& shelf);

/// The tool has another name from now on.
void rename_on_shelf(const std::string& before, const std::string& now, BrushShelf& shelf);

/// An empty shelf where there is no such file. Throws InputError that names the file and the place in it
/// for anything malformed.
BrushShelf read_brush_shelf(const std::filesystem::path& file);

/// Written aside, its folder made where there is none. Throws InputError where that cannot be written.
void write_brush_shelf(const BrushShelf& shelf, const std::filesystem::path& file);

}  // namespace pastoso::tools

// The tools as a painter has put them: favourites, those used last, in what order and under which tags.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace pastoso::tools {

inline constexpr std::size_t kMostRecentBrushes = 12;

/// A painter's own word for some tools.
struct BrushTag {
    std::string name;                ///< not blank, and no other tag's
    std::vector<std::string> tools;  ///< by name, each once, one at least
    friend bool operator==(const BrushTag&, const BrushTag&) = default;
};

struct BrushShelf {
    std::vector<std::string> favourites;  ///< names of tools, each once, in the painter's order
    std::vector<std::string> recent;      ///< the latest first, at most kMostRecentBrushes
    std::vector<std::string> order{};     ///< within each family; those left out follow as they come
    std::vector<BrushTag> tags{};         ///< in the order they were made
    friend bool operator==(const BrushShelf&, const BrushShelf&) = default;
};

bool is_favourite(const std::string& tool, const BrushShelf& shelf);
void set_favourite(const std::string& tool, bool favourite, BrushShelf& shelf);

/// Puts the tool first among the recent ones.
void note_recent(const std::string& tool, BrushShelf& shelf);

/// Null where there is none of that name.
const BrushTag* find_tag(const std::string& name, const BrushShelf& shelf);

/// Gives the tool a tag or takes it away. A tag comes with its first tool and goes with its last. False
/// for a tag of blanks.
bool set_tag(const std::string& tool, const std::string& tag, bool tagged, BrushShelf& shelf);

/// `all`, in which those that are `shown` stand in that order on the places they have together.
std::vector<std::string> rearranged(std::vector<std::string> all, const std::vector<std::string>& shown);

/// The tag's tools in this order. Nothing where there is no such tag.
void arrange_tag(const std::string& tag, const std::vector<std::string>& shown, BrushShelf& shelf);

/// The tool has another name from now on.
void rename_on_shelf(const std::string& before, const std::string& now, BrushShelf& shelf);

/// An empty shelf where there is no such file. Throws InputError that names the file and the place in it
/// for anything malformed.
BrushShelf read_brush_shelf(const std::filesystem::path& file);

/// Written aside, its folder made where there is none. Throws InputError where that cannot be written.
void write_brush_shelf(const BrushShelf& shelf, const std::filesystem::path& file);

}  // namespace pastoso::tools

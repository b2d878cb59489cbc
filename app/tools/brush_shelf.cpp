#include "tools/brush_shelf.hpp"

#include "tools/memory_file.hpp"

#include <algorithm>

namespace pastoso::tools {
namespace {

using files::Json;
using files::JsonPlace;
using Names = std::vector<std::string>;

constexpr int kVersion = 1;

bool has(const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Each once.
Names read_names(const JsonPlace& list) {
    Names names;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string name = list.element(i).text();
        if (!has(names, name)) names.push_back(name);
    }
    return names;
}

}  // namespace

bool is_favourite(const std::string& tool, const BrushShelf& shelf) {
    return has(shelf.favourites, tool);
}

void set_favourite(const std::string& tool, bool favourite, BrushShelf& shelf) {
    if (!favourite)
        std::erase(shelf.favourites, tool);
    else if (!is_favourite(tool, shelf))
        shelf.favourites.push_back(tool);
}

void note_recent(const std::string& tool, BrushShelf& shelf) {
    std::erase(shelf.recent, tool);
    shelf.recent.insert(shelf.recent.begin(), tool);
    if (shelf.recent.size() > kMostRecentBrushes) shelf.recent.pop_back();
}

void rename_on_shelf(const std::string& before, const std::string& now, BrushShelf& shelf) {
    for (Names* names : {&shelf.favourites, &shelf.recent}) {
        if (!has(*names, before)) continue;
        std::erase(*names, now);
        std::replace(names->begin(), names->end(), before, now);
    }
}

BrushShelf read_brush_shelf(const std::filesystem::path& file) {
    BrushShelf shelf;
    read_memory(file, kVersion, [&](const JsonPlace& root) {
        root.allow_only({"version", "favourites", "recent"});
        shelf.favourites = read_names(root.entry("favourites"));
        shelf.recent = read_names(root.entry("recent"));
        shelf.recent.resize(std::min(shelf.recent.size(), kMostRecentBrushes));
    });
    return shelf;
}

void write_brush_shelf(const BrushShelf& shelf, const std::filesystem::path& file) {
    write_memory({{"version", kVersion}, {"favourites", shelf.favourites}, {"recent", shelf.recent}},
                 file);
}

}  // namespace pastoso::tools

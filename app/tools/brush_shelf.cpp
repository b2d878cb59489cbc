#include "tools/brush_shelf.hpp"

#include "core/text.hpp"
#include "tools/memory_file.hpp"

#include <algorithm>
#include <utility>

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

BrushTag* find_own_tag(const std::string& name, BrushShelf& shelf) {
    const auto found = std::ranges::find(shelf.tags, name, &BrushTag::name);
    return found == shelf.tags.end() ? nullptr : &*found;
}

void read_tag(const JsonPlace& place, BrushShelf& shelf) {
    place.allow_only({"name", "tools"});
    const std::string name = place.entry("name").text();
    if (core::is_blank(name)) place.entry("name").fail("a tag needs a name.");
    if (find_tag(name, shelf) != nullptr) place.entry("name").fail("\"%1\" is there twice.", name);
    for (const std::string& tool : read_names(place.entry("tools")))
        set_tag(tool, name, true, shelf);
}

void rename_in(Names& names, const std::string& before, const std::string& now) {
    if (!has(names, before)) return;
    std::erase(names, now);
    std::replace(names.begin(), names.end(), before, now);
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
    for (Names* names : {&shelf.favourites, &shelf.recent, &shelf.order})
        rename_in(*names, before, now);
    for (BrushTag& tag : shelf.tags)
        rename_in(tag.tools, before, now);
}

const BrushTag* find_tag(const std::string& name, const BrushShelf& shelf) {
    const auto found = std::ranges::find(shelf.tags, name, &BrushTag::name);
    return found == shelf.tags.end() ? nullptr : &*found;
}

bool set_tag(const std::string& tool, const std::string& tag, bool tagged, BrushShelf& shelf) {
    if (core::is_blank(tag)) return false;
    BrushTag* own = find_own_tag(tag, shelf);
    if (own == nullptr && tagged)
        shelf.tags.push_back({tag, {tool}});
    else if (own != nullptr && !tagged)
        std::erase(own->tools, tool);
    else if (own != nullptr && !has(own->tools, tool))
        own->tools.push_back(tool);
    std::erase_if(shelf.tags, [](const BrushTag& one) { return one.tools.empty(); });
    return true;
}

Names rearranged(Names all, const Names& shown) {
    std::size_t next = 0;
    const Names before = all;
    for (std::string& name : all) {
        if (!has(shown, name)) continue;
        while (!has(before, shown[next]))
            ++next;
        name = shown[next++];
    }
    return all;
}

void arrange_tag(const std::string& tag, const Names& shown, BrushShelf& shelf) {
    if (BrushTag* own = find_own_tag(tag, shelf)) own->tools = rearranged(own->tools, shown);
}

BrushShelf read_brush_shelf(const std::filesystem::path& file) {
    BrushShelf shelf;
    read_memory(file, kVersion, [&](const JsonPlace& root) {
        root.allow_only({"version", "favourites", "recent", "order", "tags"});
        shelf.favourites = read_names(root.entry("favourites"));
        shelf.recent = read_names(root.entry("recent"));
        shelf.recent.resize(std::min(shelf.recent.size(), kMostRecentBrushes));
        if (const auto order = root.optional_entry("order")) shelf.order = read_names(*order);
        const auto tags = root.optional_entry("tags");
        for (std::size_t i = 0; tags && i < tags->size(); ++i)
            read_tag(tags->element(i), shelf);
    });
    return shelf;
}

void write_brush_shelf(const BrushShelf& shelf, const std::filesystem::path& file) {
    Json tags = Json::array();
    for (const BrushTag& tag : shelf.tags)
        tags.push_back({{"name", tag.name}, {"tools", tag.tools}});
    write_memory({{"version", kVersion},
                  {"favourites", shelf.favourites},
                  {"recent", shelf.recent},
                  {"order", shelf.order},
                  {"tags", std::move(tags)}},
                 file);
}

}  // namespace pastoso::tools

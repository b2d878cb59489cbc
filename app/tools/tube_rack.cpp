#include "tools/tube_rack.hpp"

#include "core/text.hpp"
#include "core/text_file.hpp"
#include "tools/memory_file.hpp"

#include <algorithm>

namespace pastoso::tools {
namespace {

using files::Json;
using files::JsonPlace;

constexpr int kVersion = 1;

/// Of files with sets alone.
constexpr const char* kFormat = "pastoso-tube-sets";
constexpr std::size_t kMostBytes = std::size_t{1} << 20;

bool holds(const Tubes& tubes, const std::string& tube) {
    return std::find(tubes.begin(), tubes.end(), tube) != tubes.end();
}

template <class Rack>
auto* find_set(const std::string& name, Rack& rack) {
    const auto found = std::find_if(rack.sets.begin(), rack.sets.end(),
                                    [&](const TubeSet& set) { return set.name == name; });
    return found == rack.sets.end() ? nullptr : &*found;
}

/// `first`, and behind them those of `others` that are not among them.
Tubes followed_by(Tubes first, const Tubes& others) {
    for (const std::string& tube : others)
        if (!holds(first, tube)) first.push_back(tube);
    return first;
}

Tubes read_tubes(const JsonPlace& place) {
    Tubes tubes;
    for (std::size_t i = 0; i < place.size(); ++i)
        tubes.push_back(place.element(i).text());
    return followed_by({}, tubes);
}

void read_set(const JsonPlace& place, TubeRack& rack) {
    place.allow_only({"name", "tubes"});
    const std::string name = place.entry("name").text();
    if (!save_set(name, read_tubes(place.entry("tubes")), rack))
        place.entry("name").fail("a set needs a name.");
}

void read_sets(const JsonPlace& place, TubeRack& rack) {
    for (std::size_t i = 0; i < place.size(); ++i)
        read_set(place.element(i), rack);
}

Json sets_json(const std::vector<TubeSet>& sets) {
    Json json = Json::array();
    for (const TubeSet& set : sets)
        json.push_back({{"name", set.name}, {"tubes", set.tubes}});
    return json;
}

std::string free_name(const std::string& name, const TubeRack& rack) {
    std::string free = name;
    for (int number = 2; find_set(free, rack) != nullptr; ++number)
        free = name + ' ' + std::to_string(number);
    return free;
}

}  // namespace

const TubeSet* chosen_set(const TubeRack& rack) {
    return find_set(rack.chosen, rack);
}

Tubes shown_tubes(const TubeRack& rack, const Tubes& all) {
    const TubeSet* set = chosen_set(rack);
    Tubes shown = set != nullptr ? set->tubes : followed_by(rack.order, all);
    std::erase_if(shown, [&](const std::string& tube) { return !holds(all, tube); });
    return shown;
}

void arrange(const Tubes& shown, TubeRack& rack) {
    TubeSet* set = find_set(rack.chosen, rack);
    Tubes& order = set != nullptr ? set->tubes : rack.order;
    order = followed_by(shown, order);
}

bool save_set(const std::string& name, const Tubes& tubes, TubeRack& rack) {
    if (core::is_blank(name)) return false;
    rack.chosen = name;
    if (TubeSet* same = find_set(name, rack))
        same->tubes = tubes;
    else
        rack.sets.push_back({name, tubes});
    return true;
}

bool rename_chosen(const std::string& name, TubeRack& rack) {
    TubeSet* set = find_set(rack.chosen, rack);
    const TubeSet* same = find_set(name, rack);
    if (set == nullptr || core::is_blank(name) || (same != nullptr && same != set)) return false;
    set->name = rack.chosen = name;
    return true;
}

void remove_chosen(TubeRack& rack) {
    std::erase_if(rack.sets, [&](const TubeSet& set) { return set.name == rack.chosen; });
    rack.chosen.clear();
}

void put_into_set(const std::string& tube, const std::string& name, TubeRack& rack) {
    if (TubeSet* set = find_set(name, rack)) set->tubes = followed_by(set->tubes, {tube});
}

void take_out(const std::string& tube, TubeRack& rack) {
    if (TubeSet* set = find_set(rack.chosen, rack)) std::erase(set->tubes, tube);
}

int add_sets(const std::vector<TubeSet>& sets, TubeRack& rack) {
    int added = 0;
    for (const TubeSet& set : sets) {
        if (std::ranges::find(rack.sets, set) != rack.sets.end()) continue;
        rack.sets.push_back({free_name(set.name, rack), set.tubes});
        ++added;
    }
    return added;
}

void write_tube_sets(const std::vector<TubeSet>& sets, const std::filesystem::path& file) {
    write_memory({{"format", kFormat}, {"version", kVersion}, {"sets", sets_json(sets)}}, file);
}

std::vector<TubeSet> read_tube_sets(const std::filesystem::path& file) {
    const std::string name = file.string();
    const Json json = files::parse_json(core::read_text_file(file, kMostBytes), name);
    const JsonPlace root(json, name);
    root.allow_only({"format", "version", "sets"});
    const std::string format = root.entry("format").text();
    if (format != kFormat) root.entry("format").fail("\"%1\" is not one of %2.", format, kFormat);
    root.entry("version").integer(kVersion, kVersion);
    TubeRack read;
    read_sets(root.entry("sets"), read);
    return read.sets;
}

TubeRack read_rack(const std::filesystem::path& file) {
    TubeRack rack;
    read_memory(file, kVersion, [&](const JsonPlace& root) {
        root.allow_only({"version", "order", "sets", "chosen"});
        rack.order = read_tubes(root.entry("order"));
        read_sets(root.entry("sets"), rack);
        rack.chosen = root.entry("chosen").text();
    });
    return rack;
}

void write_rack(const TubeRack& rack, const std::filesystem::path& file) {
    write_memory({{"version", kVersion},
                  {"order", rack.order},
                  {"sets", sets_json(rack.sets)},
                  {"chosen", rack.chosen}},
                 file);
}

}  // namespace pastoso::tools

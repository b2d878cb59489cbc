#include "tools/memory_merge.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace pastoso::tools {
namespace {

using files::Json;

Json entry(const Json& object, const std::string& key) {
    return object.is_object() && object.contains(key) ? object.at(key) : Json();
}

Json merged_objects(const Json& before, const Json& mine, const Json& theirs) {
    Json both = Json::object();
    for (const Json* object : {&mine, &theirs})
        for (const auto& item : object->items()) {
            const std::string& key = item.key();
            Json value = merged(entry(before, key), entry(mine, key), entry(theirs, key));
            if (!value.is_null()) both[key] = std::move(value);
        }
    return both;
}

/// Empty for what is not called anything.
std::string name_of(const Json& element) {
    const Json name = element.is_object() ? entry(element, "name") : element;
    return name.is_string() ? name.get<std::string>() : std::string();
}

bool is_named(const Json& list) {
    return list.is_array() && std::ranges::all_of(list, [](const Json& element) {
               return element.is_string() || !name_of(element).empty();
           });
}

Json element(const Json& list, const std::string& name) {
    if (!list.is_array()) return {};
    const auto found = std::ranges::find_if(list, [&](const Json& one) { return name_of(one) == name; });
    return found == list.end() ? Json() : *found;
}

Json merged_lists(const Json& before, const Json& mine, const Json& theirs) {
    Json both = Json::array();
    const auto add = [&](const Json& list, bool only_new) {
        for (const Json& one : list) {
            const std::string name = name_of(one);
            if (only_new && !element(mine, name).is_null()) continue;
            Json value = merged(element(before, name), element(mine, name), element(theirs, name));
            if (!value.is_null()) both.push_back(std::move(value));
        }
    };
    add(mine, false);
    add(theirs, true);
    return both;
}

}  // namespace

Json merged(const Json& before, const Json& mine, const Json& theirs) {
    if (mine == theirs || theirs == before) return mine;
    if (mine == before) return theirs;
    if (mine.is_object() && theirs.is_object()) return merged_objects(before, mine, theirs);
    if (is_named(mine) && is_named(theirs)) return merged_lists(before, mine, theirs);
    return mine;
}

}  // namespace pastoso::tools

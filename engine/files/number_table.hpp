// Tables that give an object's numbers their names (liquid::TeaNumber, tank::TankNumber), as entries of
// a JSON object.
#pragma once

#include "files/json_place.hpp"

#include <string_view>
#include <type_traits>
#include <vector>

namespace pastoso::files {

/// Adds the table's names to the keys that an object may have.
template <class Table>
void add_keys(std::vector<std::string_view>& keys, const Table& table) {
    for (const auto& number : table)
        keys.emplace_back(number.key);
}

/// Numbers that the JSON object does not name stay as they are.
template <class Table, class Object>
void read_numbers(const JsonPlace& place, const Table& table, Object& object) {
    for (const auto& number : table) {
        auto& value = object.*number.value;
        if (const auto entry = place.optional_entry(number.key))
            value = static_cast<std::remove_reference_t<decltype(value)>>(entry->number());
    }
}

template <class Table, class Object>
void write_numbers(Json& json, const Table& table, const Object& object) {
    for (const auto& number : table)
        json[number.key] = object.*number.value;
}

}  // namespace pastoso::files

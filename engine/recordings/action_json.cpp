#include "recordings/action_json.hpp"

#include "recordings/field_json.hpp"

#include <string_view>
#include <type_traits>

namespace pastoso::recordings {
namespace {

using document::Action;
using document::Table;

constexpr std::string_view kStroke = "stroke";

/// Calls visit(type) for each action that has an entry of its own.
void for_each_entry(auto&& visit) {
    document::AllActions::for_each([&]<class A>(std::type_identity<A> type) {
        if constexpr (std::string_view(Table<A>::kTraits.key) != kStroke) visit(type);
    });
}

std::string entry_keys() {
    std::string keys(kStroke);
    for_each_entry(
        [&]<class A>(std::type_identity<A>) { keys += std::string(", ") + Table<A>::kTraits.key.value; });
    return keys;
}

}  // namespace

files::Json action_json(const Action& action) {
    return std::visit([](const auto& told) { return fields_json(told); }, action);
}

FoundAction read_action(const files::JsonPlace& entry, ValueReader& values) {
    std::optional<FoundAction> found;
    for_each_entry([&]<class A>(std::type_identity<A>) {
        if (found) return;
        const char* key = Table<A>::kTraits.key;
        const auto content = entry.optional_entry(key);
        if (!content) return;
        entry.allow_only({"tick", key});
        found = FoundAction{read_fields<A>(*content, values), *content};
    });
    if (!found) entry.fail("expected one of %1 beside the tick.", entry_keys());
    return *found;
}

files::Json set_tracing_json(const document::SetTracing& set) {
    return fields_json(set);
}

document::SetTracing read_set_tracing(const files::JsonPlace& object) {
    ValueReader values;
    return read_fields<document::SetTracing>(object, values);
}

files::Json set_reference_json(const document::SetReference& set) {
    return fields_json(set);
}

document::SetReference read_set_reference(const files::JsonPlace& object) {
    ValueReader values;
    return read_fields<document::SetReference>(object, values);
}

files::Json look_json(const document::LayerLook& look) {
    return fields_json(look);
}

document::LayerLook read_look(const files::JsonPlace& object) {
    ValueReader values;
    document::LayerLook look;
    Table<document::LayerLook>::fields(FieldReader<document::LayerLook>(object, look, values));
    return look;
}

}  // namespace pastoso::recordings

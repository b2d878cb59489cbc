#include "files/json_place.hpp"

#include "core/json_depth.hpp"

#include <algorithm>

namespace pastoso::files {
namespace {

/// The library's message without its own number and place: what follows the last "]" or "column N: ".
std::string plain_reason(const std::string& message) {
    const std::size_t column = message.find("column ");
    if (column != std::string::npos) {
        const std::size_t colon = message.find(": ", column);
        if (colon != std::string::npos) return message.substr(colon + 2);
    }
    const std::size_t bracket = message.find("] ");
    return bracket == std::string::npos ? message : message.substr(bracket + 2);
}

long line_of_byte(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    return 1 + std::count(before.begin(), before.end(), '\n');
}

/// The value as it stands in the file, shortened to what fits a sentence. What is nested is not written
/// out: a malicious file may nest deeper than the stack is.
core::Message excerpt(const Json& value) {
    if (value.is_array()) return core::message("a list");
    if (value.is_object()) return core::message("an object");
    constexpr std::size_t kLongest = 40;
    std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
    return core::Message::verbatim(text);
}

}  // namespace

Json parse_json(std::string_view text, const std::string& file) {
    core::check_json_depth(text, file);
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw core::located_error(file, line_of_byte(text, error.byte), "this is not valid JSON: %1.",
                                  plain_reason(error.what()));
    } catch (const Json::exception& error) {
        throw core::located_error(file, 0, "this is not valid JSON: %1.", plain_reason(error.what()));
    }
}

void JsonPlace::fail(const core::Message& message) const {
    if (path_.empty()) throw core::InputError("%1: %2", *file_, message);
    throw core::InputError("%1, %2: %3", *file_, path_, message);
}

void JsonPlace::expect(bool is_kind, core::Pattern<0> kind) const {
    if (!is_kind) fail("expected %1, found %2.", core::message(kind), excerpt(*value_));
}

JsonPlace JsonPlace::entry(const char* key) const {
    std::optional<JsonPlace> found = optional_entry(key);
    if (!found) fail("the entry \"%1\" is missing.", key);
    return *std::move(found);
}

std::optional<JsonPlace> JsonPlace::optional_entry(const char* key) const {
    expect(value_->is_object(), core::Pattern<0>("an object"));
    const auto found = value_->find(key);
    if (found == value_->end()) return std::nullopt;
    return JsonPlace(*found, *file_, path_.empty() ? key : path_ + "." + key);
}

void JsonPlace::allow_only(std::span<const std::string_view> keys) const {
    expect(value_->is_object(), core::Pattern<0>("an object"));
    for (const auto& item : value_->items()) {
        if (std::find(keys.begin(), keys.end(), item.key()) == keys.end()) {
            fail("there is no such entry as \"%1\" here.", item.key());
        }
    }
}

std::size_t JsonPlace::size() const {
    expect(value_->is_array(), core::Pattern<0>("a list"));
    return value_->size();
}

JsonPlace JsonPlace::element(std::size_t index) const {
    return {(*value_)[index], *file_, path_ + "[" + std::to_string(index) + "]"};
}

double JsonPlace::number() const {
    expect(value_->is_number(), core::Pattern<0>("a number"));
    return value_->get<double>();
}

std::int64_t JsonPlace::integer(std::int64_t least, std::int64_t most) const {
    expect(value_->is_number_integer(), core::Pattern<0>("a whole number"));
    const bool fits =
        !value_->is_number_unsigned() || value_->get<std::uint64_t>() <= std::uint64_t{INT64_MAX};
    const std::int64_t number = fits ? value_->get<std::int64_t>() : INT64_MAX;
    if (number < least || number > most) {
        fail("%1 is not between %2 and %3.", excerpt(*value_), least, most);
    }
    return number;
}

std::string JsonPlace::text() const {
    expect(value_->is_string(), core::Pattern<0>("a text"));
    return value_->get<std::string>();
}

bool JsonPlace::boolean() const {
    expect(value_->is_boolean(), core::Pattern<0>("true or false"));
    return value_->get<bool>();
}

double JsonPlace::number_or(const char* key, double otherwise) const {
    const auto place = optional_entry(key);
    return place ? place->number() : otherwise;
}

bool JsonPlace::boolean_or(const char* key, bool otherwise) const {
    const auto place = optional_entry(key);
    return place ? place->boolean() : otherwise;
}

void check_format(const JsonPlace& root, const FileFormat& format) {
    const bool has_format = root.value().is_object() && root.value().contains("format");
    const Json* name = has_format ? &root.entry("format").value() : nullptr;
    if (name == nullptr || !name->is_string() || name->get<std::string>() != format.name) {
        root.fail("this is not %1; it would begin with \"format\": \"%2\".", core::message(format.thing),
                  format.name);
    }
    const std::int64_t version = root.entry("version").integer(1, INT32_MAX);
    if (version > format.newest) {
        root.fail("this was written by a newer Pastoso (%1 %2; this program reads up to %3).",
                  core::message(format.format), version, format.newest);
    }
}

}  // namespace pastoso::files

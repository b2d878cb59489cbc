// A value in a JSON file together with its place there, so that every complaint says where.
#pragma once

#include "core/error.hpp"

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace pastoso::files {

using Json = nlohmann::ordered_json;

/// Parses a whole file. Throws InputError with the line when `text` is not JSON.
Json parse_json(std::string_view text, const std::string& file);

/// A view of a value; the value and the file's name outlive it. Every function that reads throws
/// InputError "FILE, events[3].tick: MESSAGE" when the value is not what is asked for.
class JsonPlace {
  public:
    JsonPlace(const Json& value, const std::string& file, std::string path = {})
        : value_(&value), file_(&file), path_(std::move(path)) {}

    const Json& value() const { return *value_; }
    const std::string& file() const { return *file_; }
    const std::string& path() const { return path_; }

    [[noreturn]] void fail(const core::Message& message) const;
    template <class... Arguments>
    [[noreturn]] void fail(core::Pattern<sizeof...(Arguments)> pattern,
                           const Arguments&... arguments) const {
        fail(core::message(pattern, arguments...));
    }

    /// Runs a check that throws InputError without a place, and adds the place.
    template <class Check>
    void guard(Check&& check) const {
        try {
            check();
        } catch (const core::InputError& error) {
            fail(error.message());
        }
    }

    /// An object's entry; entry() must be there.
    JsonPlace entry(const char* key) const;
    std::optional<JsonPlace> optional_entry(const char* key) const;
    /// Fails at the first key that is not in the list.
    void allow_only(std::initializer_list<std::string_view> keys) const {
        allow_only(std::span(keys.begin(), keys.size()));
    }
    void allow_only(std::span<const std::string_view> keys) const;

    /// An array's length and elements.
    std::size_t size() const;
    JsonPlace element(std::size_t index) const;

    double number() const;
    std::int64_t integer(std::int64_t least, std::int64_t most) const;
    std::string text() const;
    bool boolean() const;

    /// An object's entry, or `otherwise` where there is none.
    double number_or(const char* key, double otherwise) const;
    bool boolean_or(const char* key, bool otherwise) const;

  private:
    void expect(bool is_kind, core::Pattern<0> kind) const;

    const Json* value_;
    const std::string* file_;
    std::string path_;
};

/// What a file says of itself: {"format": NAME, "version": 1 to NEWEST, ...}.
struct FileFormat {
    const char* name;    ///< "pastoso-scene"
    core::Pattern<0> thing;   ///< what the file is: "a scene"
    core::Pattern<0> format;  ///< how errors call its format: "scene format"
    int newest;          ///< version that this program reads
};

/// Fails unless the file is of that format, in a version up to the newest.
void check_format(const JsonPlace& root, const FileFormat& format);

}  // namespace pastoso::files

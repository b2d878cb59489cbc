// Which keys the painter uses: kept between two starts.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace pastoso::tools {

struct KeySettings {
    std::string set;  ///< the name of the set that they start from; empty: the first
    /// The painter's own, by the name of the command, as Qt writes keys in every language; none: the
    /// command has no key.
    std::map<std::string, std::vector<std::string>> own;
    friend bool operator==(const KeySettings&, const KeySettings&) = default;
};

/// Throw InputError for what is none.
struct KeyChecks {
    std::function<void(const std::string& name)> set;
    std::function<void(const std::string& text)> key;
};

/// None of the painter's own where there is no such file. Throws InputError that names the file, the
/// place in it and the value for anything malformed, and for a key that two commands have.
KeySettings read_key_settings(const std::filesystem::path& file, const KeyChecks& checks);

/// Written aside, its folder made where there is none. Throws InputError where that cannot be written.
void write_key_settings(const KeySettings& settings, const std::filesystem::path& file);

}  // namespace pastoso::tools

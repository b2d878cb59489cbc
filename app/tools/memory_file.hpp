// Small JSON files in which the window remembers something between two starts.
#pragma once

#include "files/json_place.hpp"

#include <filesystem>
#include <functional>

namespace pastoso::tools {

/// Calls `read` with the root of the file; does nothing where there is no such file. Throws InputError
/// that names the file and the place in it: when it is no JSON, is of another version, or `read` throws.
void read_memory(const std::filesystem::path& file, int version,
                 const std::function<void(const files::JsonPlace& root)>& read);

/// What stands in the file; null where there is none, and where it is no JSON.
files::Json memory_in(const std::filesystem::path& file);

/// Written aside, its folder made where there is none. Throws InputError where that cannot be written.
void write_memory(const files::Json& root, const std::filesystem::path& file);

}  // namespace pastoso::tools

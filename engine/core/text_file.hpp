// Whole small files in, whole files out.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pastoso::core {

/// The whole file as text. Throws InputError naming the path when it cannot be opened, is no regular file
/// (regular_file.hpp), or is larger than `max_bytes`.
std::string read_text_file(const std::filesystem::path& path, std::size_t max_bytes = std::size_t{1} << 30);

/// The files of a folder that end in `extension` (".json"), in the order of their names; none where there is no
/// such folder.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder, std::string_view extension);

/// Writes the text aside and puts it in place (output_file.hpp). Throws InputError when that fails; `path` is then
/// as it was.
void write_text_file(const std::filesystem::path& path, std::string_view text);

}  // namespace pastoso::core

// Whole small files in, whole files out: read in one piece, written aside and renamed.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace pastoso::core {

/// The whole file as text. Throws InputError naming the path when it cannot be opened, is a folder, or is
/// larger than `max_bytes`.
std::string read_text_file(const std::filesystem::path& path, std::size_t max_bytes = std::size_t{1} << 30);

/// The files of a folder that end in `extension` (".json"), in the order of their names; none where there is no
/// such folder.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder, std::string_view extension);

/// Calls `write(temporary_path)`, then flushes the temporary file to the disk, renames it to `path` and flushes
/// the folder: readers see the old file or the whole new one, after a power cut too. If `write` throws, the temporary file is removed and `path` is as it was. Throws InputError
/// when the folder does not exist or is not writable. The temporary name keeps the extension of `path`.
void write_aside(const std::filesystem::path& path,
                 const std::function<void(const std::filesystem::path& temporary)>& write);

/// The same, but `write` may give up: where it returns false, `path` is as it was, and false is returned.
bool write_aside_unless(const std::filesystem::path& path,
                        const std::function<bool(const std::filesystem::path& temporary)>& write);

/// write_aside() of a text.
void write_text_file(const std::filesystem::path& path, std::string_view text);

}  // namespace pastoso::core

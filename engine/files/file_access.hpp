// Whether a file can be read or written, asked before long work depends on it.
#pragma once

#include <filesystem>

namespace pastoso::files {

/// Throws InputError when `path` cannot be opened for reading or is no regular file.
void check_readable(const std::filesystem::path& path);

/// Throws InputError where core::OutputFile would not be made for `path`. Leaves nothing behind.
void check_writable(const std::filesystem::path& path);

/// Creates the folder where it is missing (its parent must exist) and checks that files can be put
/// there. Throws InputError otherwise.
void make_folder(const std::filesystem::path& folder);

}  // namespace pastoso::files

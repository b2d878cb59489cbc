// Zip archives taken apart and put together again, for files that the program itself would not write.
#pragma once

#include "project/zip_file.hpp"

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace pastoso::project {

using Entries = std::vector<std::pair<std::string, std::string>>;

/// Names and contents in the order of the archive.
Entries entries_of(std::span<const std::byte> archive);

/// An archive of stored entries; with `deflated` they are compressed by the archive.
Bytes archive_of(const Entries& entries, bool deflated = false);

/// The archive with one entry changed.
Bytes changed(std::span<const std::byte> archive, const std::string& entry,
              const std::function<void(std::string&)>& change);

/// The text with the first occurrence of `from` replaced; it is there.
std::string replaced(std::string text, const std::string& from, const std::string& to);

}  // namespace pastoso::project

// Whether a file is still the one that was read or written.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace pastoso::commands {

/// Tells what a project holds from what another program has made of it. Times and inodes would also
/// change where a file is only copied back or synchronised.
struct FileStamp {
    std::uint64_t size_bytes = 0;
    std::uint64_t end_hash = 0;  ///< of its last bytes, the checksums of all that it holds
    friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// None where there is no plain file, or none that may be read.
std::optional<FileStamp> stamp_of(const std::filesystem::path& path);

}  // namespace pastoso::commands

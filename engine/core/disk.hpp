// What the system says of a disk, and bytes on their way to it.
#pragma once

#include "core/message.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <sys/types.h>

namespace pastoso::core {

/// Writes all bytes to an open file, from a place in bytes on. False when that fails; errno then says
/// why.
bool write_all(int file, std::span<const std::byte> bytes, std::uint64_t place) noexcept;

/// Whether an error of that number means that there is no room: on the disk, or in this user's share of
/// it.
bool says_full(int reason);

/// "a folder", "a named pipe": what stands where a file should, by the mode that stat() tells.
Message kind_of_file(mode_t mode);

/// What this user may still write to the disk that holds the folder; none where the system does not say.
std::optional<std::uint64_t> free_bytes(const std::filesystem::path& folder);

}  // namespace pastoso::core

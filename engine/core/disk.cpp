#include "core/disk.hpp"

#include <cerrno>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace pastoso::core {

bool write_all(int file, std::span<const std::byte> bytes, std::uint64_t place) noexcept {
    while (!bytes.empty()) {
        const ssize_t written = ::pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(place));
        if (written < 0 && errno == EINTR) continue;
        if (written == 0) errno = ENOSPC;
        if (written <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(written));
        place += static_cast<std::uint64_t>(written);
    }
    return true;
}

bool says_full(int reason) {
    return reason == ENOSPC || reason == EDQUOT;
}

Message kind_of_file(mode_t mode) {
    if (S_ISDIR(mode)) return message("a folder");
    if (S_ISFIFO(mode)) return message("a named pipe");
    if (S_ISSOCK(mode)) return message("a socket");
    return S_ISCHR(mode) || S_ISBLK(mode) ? message("a device") : message("something else");
}

std::optional<std::uint64_t> free_bytes(const std::filesystem::path& folder) {
    std::error_code unknown;
    const std::filesystem::space_info space = std::filesystem::space(folder, unknown);
    if (unknown) return std::nullopt;
    return space.available;
}

}  // namespace pastoso::core

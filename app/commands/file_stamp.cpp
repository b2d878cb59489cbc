#include "commands/file_stamp.hpp"

#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/regular_file.hpp"

#include <algorithm>
#include <span>
#include <string>

namespace pastoso::commands {
namespace {

/// Holds the directory of a project with many thousand entries.
constexpr std::uint64_t kEnd_bytes = 1 << 20;

}  // namespace

std::optional<FileStamp> stamp_of(const std::filesystem::path& path) {
    try {
        const core::RegularFile file(path);
        const std::uint64_t read_bytes = std::min(file.bytes(), kEnd_bytes);
        const std::string end = file.text_at(file.bytes() - read_bytes, static_cast<std::size_t>(read_bytes));
        core::Hash64 hash;
        hash.add(std::span<const char>(end));
        return FileStamp{file.bytes(), hash.value()};
    } catch (const core::InputError&) {
        return std::nullopt;
    }
}

}  // namespace pastoso::commands

#include "core/text_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "core/error.hpp"

namespace pastoso::core {
namespace {

std::filesystem::path temporary_beside(const std::filesystem::path& path) {
    return path.parent_path() /
           ("." + path.stem().string() + "." + std::to_string(::getpid()) + ".part" + path.extension().string());
}

/// False, too, for a path that may not be looked at: opening it gives the better message.
bool is_folder(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::is_directory(path, ignored);
}

/// Creates an empty file, so that an unwritable place is reported before any work is done on it.
void create_empty(const std::filesystem::path& temporary, const std::filesystem::path& path) {
    const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0) throw InputError(path.string() + ": cannot be written (" + std::strerror(errno) + ").");
    ::close(file);
}

void flush_to_disk(const std::filesystem::path& temporary, const std::filesystem::path& path) {
    const int file = ::open(temporary.c_str(), O_RDONLY | O_CLOEXEC);
    const bool flushed = file >= 0 && ::fsync(file) == 0;
    if (file >= 0) ::close(file);
    if (!flushed) throw InputError(path.string() + ": cannot be written (" + std::strerror(errno) + ").");
}

/// Takes the place of what stood there, and makes sure that the folder keeps it. Where a folder cannot be flushed
/// (some network drives), the file stands there nevertheless.
void move_into_place(const std::filesystem::path& temporary, const std::filesystem::path& path) {
    if (::rename(temporary.c_str(), path.c_str()) != 0)
        throw InputError(path.string() + ": cannot be written (" + std::strerror(errno) + ").");
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file < 0) return;
    ::fsync(file);
    ::close(file);
}

}  // namespace

std::string read_text_file(const std::filesystem::path& path, std::size_t max_bytes) {
    if (is_folder(path)) throw InputError(path.string() + ": is a folder, not a file.");
    std::ifstream stream(path, std::ios::binary | std::ios::ate);
    if (!stream) throw InputError(path.string() + ": cannot be opened (" + std::strerror(errno) + ").");
    const auto size = static_cast<std::size_t>(stream.tellg());
    if (size > max_bytes) {
        throw InputError(path.string() + ": is larger than the " + std::to_string(max_bytes) +
                         " bytes that are read at most.");
    }
    std::string text(size, '\0');
    stream.seekg(0);
    stream.read(text.data(), static_cast<std::streamsize>(size));
    if (!stream) throw InputError(path.string() + ": cannot be read to its end.");
    return text;
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder, std::string_view extension) {
    std::vector<std::filesystem::path> files;
    std::error_code missing;
    for (const auto& entry : std::filesystem::directory_iterator(folder, missing)) {
        if (entry.path().extension() == extension) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

bool write_aside_unless(const std::filesystem::path& path,
                        const std::function<bool(const std::filesystem::path&)>& write) {
    if (is_folder(path)) throw InputError(path.string() + ": is a folder, not a file.");
    const std::filesystem::path temporary = temporary_beside(path);
    create_empty(temporary, path);
    std::error_code ignored;
    try {
        if (!write(temporary)) {
            std::filesystem::remove(temporary, ignored);
            return false;
        }
        flush_to_disk(temporary, path);
        move_into_place(temporary, path);
    } catch (...) {
        std::filesystem::remove(temporary, ignored);
        throw;
    }
    return true;
}

void write_aside(const std::filesystem::path& path,
                 const std::function<void(const std::filesystem::path&)>& write) {
    write_aside_unless(path, [&](const std::filesystem::path& temporary) {
        write(temporary);
        return true;
    });
}

void write_text_file(const std::filesystem::path& path, std::string_view text) {
    write_aside(path, [&](const std::filesystem::path& temporary) {
        std::ofstream stream(temporary, std::ios::binary);
        stream.write(text.data(), static_cast<std::streamsize>(text.size()));
        stream.flush();
        if (!stream) throw InputError(path.string() + ": cannot be written (the disk may be full).");
    });
}

}  // namespace pastoso::core

#include "files/file_access.hpp"

#include "core/error.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

namespace pastoso::files {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const char* verb) {
    throw core::InputError(path.string() + ": cannot be " + verb + " (" + std::strerror(errno) + ").");
}

void refuse_folder(const std::filesystem::path& path) {
    if (std::filesystem::is_directory(path))
        throw core::InputError(path.string() + ": is a folder, not a file.");
}

}  // namespace

void check_readable(const std::filesystem::path& path) {
    refuse_folder(path);
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) refuse(path, "opened");
    ::close(file);
}

void check_writable(const std::filesystem::path& path) {
    refuse_folder(path);
    const std::filesystem::path trial = path.parent_path() / ("." + path.filename().string() + "." +
                                                              std::to_string(::getpid()) + ".trial");
    const int file = ::open(trial.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (file < 0) refuse(path, "written");
    ::close(file);
    ::unlink(trial.c_str());
}

void make_folder(const std::filesystem::path& folder) {
    if (::mkdir(folder.c_str(), 0777) != 0 && errno != EEXIST) refuse(folder, "created");
    check_writable(folder / "file");
}

}  // namespace pastoso::files

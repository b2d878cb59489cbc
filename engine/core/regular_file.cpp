#include "core/regular_file.hpp"

#include "core/disk.hpp"
#include "core/error.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace pastoso::core {
namespace {

[[noreturn]] void refuse_opening(const std::string& name) {
    throw InputError("%1: cannot be opened (%2).", name, std::strerror(errno));
}

void check_regular(const struct stat& file, const std::string& name) {
    if (!S_ISREG(file.st_mode))
        throw InputError("%1: is %2, not a file.", name, kind_of_file(file.st_mode));
}

/// Looked at before it is opened, since opening alone does something to some devices; and again
/// afterwards by whoever opens it, since another may stand there by then.
int opened(const std::filesystem::path& path, const std::string& name) {
    struct stat seen {};
    if (::stat(path.c_str(), &seen) != 0) refuse_opening(name);
    check_regular(seen, name);
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (descriptor < 0) refuse_opening(name);
    return descriptor;
}

}  // namespace

RegularFile::RegularFile(const std::filesystem::path& path)
    : name_(path.string()), descriptor_(opened(path, name_)) {
    struct stat file {};
    try {
        if (::fstat(descriptor_, &file) != 0) refuse_opening(name_);
        check_regular(file, name_);
    } catch (...) {
        ::close(descriptor_);
        throw;
    }
    bytes_ = static_cast<std::uint64_t>(file.st_size);
}

RegularFile::~RegularFile() {
    ::close(descriptor_);
}

std::size_t RegularFile::read_at(std::uint64_t place, void* to, std::size_t count) const {
    constexpr std::uint64_t kLastPlace = INT64_MAX;
    if (place > kLastPlace) return 0;
    std::size_t done = 0;
    while (done < count) {
        const ssize_t got = ::pread(descriptor_, static_cast<char*>(to) + done, count - done,
                                    static_cast<off_t>(place + done));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) throw InputError("%1: cannot be read (%2).", name_, std::strerror(errno));
        if (got == 0) break;
        done += static_cast<std::size_t>(got);
    }
    return done;
}

std::string RegularFile::text_at(std::uint64_t place, std::size_t count) const {
    const std::uint64_t left = bytes_ > place ? bytes_ - place : 0;
    std::string text(static_cast<std::size_t>(std::min<std::uint64_t>(count, left)), '\0');
    text.resize(read_at(place, text.data(), text.size()));
    return text;
}

}  // namespace pastoso::core

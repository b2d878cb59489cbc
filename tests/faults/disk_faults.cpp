// Loaded before the system's library (LD_PRELOAD), it lets writing fail below one folder: what a program asks of the
// system is counted there, and one of those calls fails, or all when the disk is full. Set by the environment:
//   PASTOSO_FAULTS_IN      the folder
//   PASTOSO_FAULTS_CALL    which call fails, from 1; 0: none
//   PASTOSO_FAULTS_BYTES   how many bytes the disk takes
//   PASTOSO_FAULTS_COUNT   a file for the number of calls, written at the end
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

namespace {

std::atomic<long> calls = 0, bytes_written = 0;

/// Which files hold something: closing another one can lose nothing.
constexpr int kMostFiles = 4096;
std::atomic<bool> holds_bytes[kMostFiles];

void mark(int file, bool holds) {
    if (file >= 0 && file < kMostFiles) holds_bytes[file] = holds;
}

const char* setting(const char* name) {
    const char* text = std::getenv(name);
    return text == nullptr ? "" : text;
}

long number(const char* name, long otherwise) {
    const char* text = setting(name);
    return text[0] == '\0' ? otherwise : std::atol(text);
}

bool is_watched(const char* path) {
    const char* folder = setting("PASTOSO_FAULTS_IN");
    return folder[0] != '\0' && std::strncmp(path, folder, std::strlen(folder)) == 0;
}

bool is_watched(int file) {
    char link[40], path[PATH_MAX];
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    const ssize_t length = ::readlink(link, path, sizeof path - 1);
    if (length < 0) return false;
    path[length] = '\0';
    return is_watched(path);
}

/// Counts a call that has to do with a watched file; true where it is to fail.
bool fails() {
    return ++calls == number("PASTOSO_FAULTS_CALL", 0);
}

template <class Function>
Function* system_function(const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

/// How much of so many bytes a watched file takes; -1 with an error.
ssize_t room_for(std::size_t count) {
    if (fails()) {
        errno = EIO;
        return -1;
    }
    const long room = number("PASTOSO_FAULTS_BYTES", LONG_MAX) - bytes_written;
    if (room <= 0 && count > 0) {
        errno = ENOSPC;
        return -1;
    }
    const long taken = static_cast<long>(count) < room ? static_cast<long>(count) : room;
    bytes_written += taken;
    return taken;
}

int open_file(const char* path, int flags, mode_t mode) {
    static const auto open_it = system_function<int(const char*, int, ...)>("open64");
    if ((flags & O_CREAT) != 0 && is_watched(path) && fails()) {
        errno = EIO;
        return -1;
    }
    return open_it(path, flags, mode);
}

mode_t mode_of(int flags, std::va_list arguments) {
    return (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
}

int result_of(bool watched, int (*call)(int), int file) {
    if (watched && fails()) {
        errno = EIO;
        return -1;
    }
    return call(file);
}

struct Report {
    ~Report() {
        const char* path = setting("PASTOSO_FAULTS_COUNT");
        if (path[0] == '\0') return;
        if (std::FILE* file = std::fopen(path, "w")) {
            std::fprintf(file, "%ld", calls.load());
            std::fclose(file);
        }
    }
};
const Report report;

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
    std::va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_of(flags, arguments);
    va_end(arguments);
    return open_file(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
    std::va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_of(flags, arguments);
    va_end(arguments);
    return open_file(path, flags, mode);
}

ssize_t write(int file, const void* bytes, std::size_t count) {
    static const auto write_it = system_function<ssize_t(int, const void*, std::size_t)>("write");
    if (is_watched(file)) {
        mark(file, true);
        const ssize_t room = room_for(count);
        if (room < 0) return -1;
        count = static_cast<std::size_t>(room);
    }
    return write_it(file, bytes, count);
}

ssize_t pwrite64(int file, const void* bytes, std::size_t count, off64_t place) {
    static const auto write_it = system_function<ssize_t(int, const void*, std::size_t, off64_t)>("pwrite64");
    if (is_watched(file)) {
        mark(file, true);
        const ssize_t room = room_for(count);
        if (room < 0) return -1;
        count = static_cast<std::size_t>(room);
    }
    return write_it(file, bytes, count, place);
}

ssize_t pwrite(int file, const void* bytes, std::size_t count, off_t place) {
    return pwrite64(file, bytes, count, place);
}

/// A short write is one that callers must expect.
ssize_t writev(int file, const iovec* parts, int count) {
    static const auto write_it = system_function<ssize_t(int, const iovec*, int)>("writev");
    return is_watched(file) ? write(file, parts[0].iov_base, parts[0].iov_len) : write_it(file, parts, count);
}

int fsync(int file) {
    static const auto sync_it = system_function<int(int)>("fsync");
    return result_of(is_watched(file), sync_it, file);
}

int close(int file) {
    static const auto close_it = system_function<int(int)>("close");
    const bool watched = file >= 0 && file < kMostFiles && holds_bytes[file] && is_watched(file);
    mark(file, false);
    const int closed = close_it(file);
    if (!watched || !fails()) return closed;
    errno = EIO;
    return -1;
}

int rename(const char* from, const char* to) {
    static const auto rename_it = system_function<int(const char*, const char*)>("rename");
    if (!is_watched(to) || !fails()) return rename_it(from, to);
    errno = EIO;
    return -1;
}

}  // extern "C"

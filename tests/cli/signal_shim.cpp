// Preloaded into a program under test: sends it the signal of number PASTOSO_SIGNAL at the moment when
// it has created a file whose name contains PASTOSO_SIGNAL_FILE, the PASTOSO_SIGNAL_COUNTth time.
#include <atomic>
#include <csignal>
#include <cstdarg>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>

namespace {

using Open = int (*)(const char*, int, ...);
using OpenAt = int (*)(int, const char*, int, ...);

template <class Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

int number_of(const char* variable) {
    const char* text = std::getenv(variable);
    return text == nullptr ? 0 : std::atoi(text);
}

int noted(const char* path, int flags, int file) {
    static std::atomic<int> created = 0;
    const char* wanted = std::getenv("PASTOSO_SIGNAL_FILE");
    const char* slash = std::strrchr(path, '/');
    const char* name = slash == nullptr ? path : slash + 1;
    if (file >= 0 && (flags & O_CREAT) != 0 && wanted != nullptr &&
        std::strstr(name, wanted) != nullptr && ++created == number_of("PASTOSO_SIGNAL_COUNT"))
        std::raise(number_of("PASTOSO_SIGNAL"));
    return file;
}

mode_t mode_of(int flags, std::va_list rest) {
    return (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
    std::va_list rest;
    va_start(rest, flags);
    const mode_t mode = mode_of(flags, rest);
    va_end(rest);
    return noted(path, flags, next<Open>("open")(path, flags, mode));
}

int open64(const char* path, int flags, ...) {
    std::va_list rest;
    va_start(rest, flags);
    const mode_t mode = mode_of(flags, rest);
    va_end(rest);
    return noted(path, flags, next<Open>("open64")(path, flags, mode));
}

int openat(int folder, const char* path, int flags, ...) {
    std::va_list rest;
    va_start(rest, flags);
    const mode_t mode = mode_of(flags, rest);
    va_end(rest);
    return noted(path, flags, next<OpenAt>("openat")(folder, path, flags, mode));
}

int openat64(int folder, const char* path, int flags, ...) {
    std::va_list rest;
    va_start(rest, flags);
    const mode_t mode = mode_of(flags, rest);
    va_end(rest);
    return noted(path, flags, next<OpenAt>("openat64")(folder, path, flags, mode));
}
}

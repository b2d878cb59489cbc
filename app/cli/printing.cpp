#include "cli/printing.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/printable.hpp"

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace pastoso::cli {
namespace {

std::string formatted(const char* format, std::va_list values) {
    std::va_list again;
    va_copy(again, values);
    const int length = std::vsnprintf(nullptr, 0, format, values);
    PASTOSO_CHECK_OP(length, >=, 0);
    std::string text(static_cast<std::size_t>(length) + 1, '\0');
    std::vsnprintf(text.data(), text.size(), format, again);
    va_end(again);
    text.pop_back();
    return text;
}

/// Of the first write to the standard output that failed; 0: none did. The stream itself remembers only
/// that one did.
int write_error = 0;

void keep_first_error() {
    if (write_error == 0) write_error = errno;
}

}  // namespace

void print(const char* format, ...) {
    std::va_list values;
    va_start(values, format);
    const std::string text = core::printable(formatted(format, values));
    va_end(values);
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) keep_first_error();
}

void complain(const std::string& sentence) {
    const std::string text = core::printable("pastoso-cli: " + sentence + "\n");
    std::fwrite(text.data(), 1, text.size(), stderr);
}

void finish_printing() {
    if (std::fflush(stdout) != 0) keep_first_error();
    if (write_error == 0) return;
    throw core::InputError("the standard output: cannot be written (%1).", std::strerror(write_error));
}

}  // namespace pastoso::cli

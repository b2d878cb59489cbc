#include "core/check.hpp"

#include "core/failed_check.hpp"

#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace pastoso::core {
namespace {

std::array<char, 1024> failure{};
std::atomic<bool> throws = false;

}  // namespace

const char* failed_check() {
    return failure.data();
}

void throw_failed_checks() {
    throws = true;
}

void fail_check(const char* file, int line, const char* expression, const std::string& detail) {
    std::snprintf(failure.data(), failure.size(), "%s:%d: broken invariant: %s%s%s%s", file, line,
                  expression, detail.empty() ? "" : " (", detail.c_str(), detail.empty() ? "" : ")");
    if (throws) throw BrokenInvariant(failure.data());
    std::fprintf(stderr, "%s\n", failure.data());
    std::abort();
}

}  // namespace pastoso::core

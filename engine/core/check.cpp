#include "core/check.hpp"

#include <cstdio>
#include <cstdlib>

namespace pastoso::core {

void fail_check(const char* file, int line, const char* expression, const std::string& detail) {
    std::fprintf(stderr, "%s:%d: broken invariant: %s%s%s%s\n", file, line, expression,
                 detail.empty() ? "" : " (", detail.c_str(), detail.empty() ? "" : ")");
    std::abort();
}

}  // namespace pastoso::core

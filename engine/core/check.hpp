// Checks of invariants: a failure is a mistake of ours, never of the user's data (for those see error.hpp).
// They stay in Release builds, tell expression, values and place, and abort or throw (failed_check.hpp).
#pragma once

#include <sstream>
#include <string>

namespace pastoso::core {

/// Prints "FILE:LINE: broken invariant: EXPRESSION (DETAIL)" to the error stream and aborts.
[[noreturn]] void fail_check(const char* file, int line, const char* expression, const std::string& detail);

template <class A, class B>
std::string describe_operands(const A& a, const B& b) {
    std::ostringstream text;
    text << a << " against " << b;
    return text.str();
}

}  // namespace pastoso::core

#define PASTOSO_CHECK(condition)                                                          \
    do {                                                                                  \
        if (!(condition)) ::pastoso::core::fail_check(__FILE__, __LINE__, #condition, ""); \
    } while (false)

#define PASTOSO_CHECK_OP(a, op, b)                                                       \
    do {                                                                                 \
        const auto& check_a = (a);                                                       \
        const auto& check_b = (b);                                                       \
        if (!(check_a op check_b))                                                       \
            ::pastoso::core::fail_check(__FILE__, __LINE__, #a " " #op " " #b,           \
                                        ::pastoso::core::describe_operands(check_a, check_b)); \
    } while (false)

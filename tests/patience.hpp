// Waiting for something that is only slow.
#pragma once

#include <chrono>
#include <thread>

namespace pastoso::tests {

/// So long a test waits for what must come: far beyond what a loaded machine takes under a sanitizer. It tells
/// a program that hangs from one that works; nothing is measured by it.
inline constexpr std::chrono::minutes kPatience{10};

/// Looks every few milliseconds whether the condition holds; false when it does not come to hold.
template <class Condition>
bool comes_true(const Condition& condition) {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
}

}  // namespace pastoso::tests

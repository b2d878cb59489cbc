// Loops over the slices of a box on the threads of a pool, and sums whose bits do not depend on how many
// threads there are.
#pragma once

#include "core/thread_pool.hpp"

#include <algorithm>
#include <vector>

namespace pastoso::liquid {

/// Calls body(k) once for every k in [begin, end). Threads take runs of neighbouring slices, so that
/// what one pass leaves in a processor's cache serves the next.
template <class Body>
void for_slices(core::ThreadPool& pool, int begin, int end, const Body& body) {
    constexpr int kRunsPerThread = 4;
    const int count = end - begin;
    if (count <= 0) return;
    const int runs =
        pool.thread_count() == 1 ? 1 : std::min(count, kRunsPerThread * pool.thread_count());
    pool.run(static_cast<std::size_t>(runs), [&](std::size_t run, int) {
        const int r = static_cast<int>(run);
        for (int k = begin + count * r / runs; k < begin + count * (r + 1) / runs; ++k)
            body(k);
    });
}

/// The sum of value(k) over [0, count), added in index order. Anything that begins as {} and has +=.
template <class Value>
auto sum_over_slices(core::ThreadPool& pool, int count, const Value& value) {
    std::vector<decltype(value(0))> parts(static_cast<std::size_t>(std::max(count, 0)));
    for_slices(pool, 0, count, [&](int k) { parts[static_cast<std::size_t>(k)] = value(k); });
    decltype(value(0)) sum{};
    for (const auto& part : parts)
        sum += part;
    return sum;
}

}  // namespace pastoso::liquid

// Work on the threads of a pool that may be told to stop.
#pragma once

#include "core/thread_pool.hpp"

#include <atomic>
#include <cstddef>
#include <functional>

namespace pastoso::trace {

/// Calls body(index) for every index in [0, count) on the threads of a pool. Before each asks `stop`, if
/// there is one, on any of them; after a true answer no other begins. False when stopped.
template <class Body>
bool run_until_stopped(core::ThreadPool& pool, std::size_t count, const std::function<bool()>& stop,
                       const Body& body) {
    std::atomic<bool> stopped = false;
    pool.run(count, [&](std::size_t index, int) {
        if (stopped || (stop && stop())) {
            stopped = true;
            return;
        }
        body(index);
    });
    return !stopped;
}

}  // namespace pastoso::trace

// The one place that starts threads: each ends with its object, and lets no exception escape.
#pragma once

#include "core/fault.hpp"

#include <functional>
#include <thread>

namespace pastoso::core {

/// Lowers the priority of the calling thread and of those that it starts, by up to 19; on Linux, threads
/// have priorities of their own.
void lower_priority(int nice);

/// Runs a function on a thread of its own and waits for its end when the object goes or is assigned to;
/// who owns it asks the function to end. For jobs there is Worker (core/worker.hpp).
class Thread {
  public:
    /// There is none.
    Thread() = default;
    /// What `body` throws ends the thread and is told on it.
    Thread(std::function<void()> body, Tell tell);

    /// Whether there is one that nobody has waited for.
    bool exists() const { return thread_.joinable(); }

    /// Waits for its end. There is none afterwards.
    void join();

  private:
    std::jthread thread_;
};

}  // namespace pastoso::core

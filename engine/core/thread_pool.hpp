// A small pool of threads for loops whose iterations write to different places. Which thread runs which
// iteration is not fixed; whoever needs a sum stores one value per iteration and adds them in index
// order.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace pastoso::core {

class ThreadPool {
  public:
    /// Uses `thread_count` threads in all, the caller of run() among them; 0 takes one per processor.
    explicit ThreadPool(int thread_count = 0);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    /// From the next run on its threads, which does not mean the caller of run(), give way to others:
    /// core::lower_priority().
    void lower_priority(int nice) { nice_ = nice; }

    int thread_count() const { return static_cast<int>(workers_.size()) + 1; }

    /// Calls body(index, worker) once for every index in [0, count), worker in [0, thread_count()), and
    /// returns when all calls have. Throws one of what the body threw. Several threads may call run() at
    /// once, each with a loop of its own, and so may a body: who finds no thread free does the loop
    /// alone.
    void run(std::size_t count, const std::function<void(std::size_t index, int worker)>& body);

  private:
    static constexpr unsigned kClosed = 1U << 31;

    /// Room for a loop under way, on a cache line of its own.
    struct alignas(64) Loop {
        const std::function<void(std::size_t, int)>* body = nullptr;
        std::size_t count = 0;
        std::atomic<std::size_t> next = 0;
        std::atomic<unsigned> workers_inside = kClosed;  ///< kClosed when it takes no more
        std::atomic<bool> taken = false;

        void take_indices(int worker);
        /// False when the loop is over: who calls run() waits for no thread that comes too late, as on a
        /// busy machine it may, but only for those that have entered.
        bool enter();
        void help(int worker);
    };

    void work(int worker);
    void start_workers();
    Loop* free_loop();

    std::array<Loop, 4> loops_;
    std::atomic<unsigned> generation_ = 0;  ///< counts the runs
    std::atomic<bool> stopping_ = false;
    std::atomic<int> nice_ = 0;
    std::vector<std::thread> workers_;
};

}  // namespace pastoso::core

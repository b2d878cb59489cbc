// A small pool of threads for loops whose iterations write to different places. Which thread runs which
// iteration is not fixed; whoever needs a sum stores one value per iteration and adds them in index
// order.
#pragma once

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
    /// returns when all calls have. Throws one of what the body threw. The body must not call run() of
    /// the same pool, and only one thread at a time may call run().
    void run(std::size_t count, const std::function<void(std::size_t index, int worker)>& body);

  private:
    void work(int worker);
    void take_indices(int worker);
    void start_workers();
    /// False when the run is over: who calls run() waits for no thread that comes too late, as on a busy
    /// machine it may, but only for those that have entered.
    bool enter();

    static constexpr unsigned kClosed = 1U << 31;

    const std::function<void(std::size_t, int)>* body_ = nullptr;
    std::size_t count_ = 0;
    std::atomic<std::size_t> next_ = 0;
    std::atomic<unsigned> generation_ = 0;  ///< counts the runs
    std::atomic<unsigned> workers_inside_ =
        kClosed;  ///< of the run under way; kClosed when it takes no more
    std::atomic<bool> stopping_ = false;
    std::atomic<int> nice_ = 0;
    std::vector<std::thread> workers_;
};

}  // namespace pastoso::core

#include "core/thread_pool.hpp"

#include "core/check.hpp"
#include "core/thread.hpp"
#include "core/thread_count.hpp"

#include <exception>

namespace pastoso::core {
namespace {

/// How often a thread looks again before it sleeps: 150 us where a pause takes 25 ns. Waking up costs
/// some tens; the runs of a solver's step, and those of a brush's steps, follow each other more closely.
constexpr int kLooksBeforeSleep = 6000;

void pause_briefly() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

template <class T>
void wait_while(const std::atomic<T>& value, T old) {
    for (int look = 0; look < kLooksBeforeSleep; ++look) {
        if (value.load(std::memory_order_acquire) != old) return;
        pause_briefly();
    }
    value.wait(old, std::memory_order_acquire);
}

/// A loop's body that no exception leaves on the pool's threads: the first is thrown where run() was called,
/// and indices that have not begun by then are left out.
class Kept {
  public:
    explicit Kept(const std::function<void(std::size_t, int)>& body) : body_(body) {}

    void call(std::size_t index, int worker) noexcept {
        if (failed_.load(std::memory_order_relaxed)) return;
        try {
            body_(index, worker);
        } catch (...) {
            if (!failed_.exchange(true)) thrown_ = std::current_exception();
        }
    }
    void throw_what_was_thrown() const {
        if (thrown_) std::rethrow_exception(thrown_);
    }

  private:
    const std::function<void(std::size_t, int)>& body_;
    std::atomic<bool> failed_ = false;
    std::exception_ptr thrown_;
};

}  // namespace

ThreadPool::ThreadPool(int thread_count) {
    PASTOSO_CHECK_OP(thread_count, >=, 0);
    const int wanted = thread_count > 0 ? thread_count : default_thread_count();
    workers_.reserve(wanted - 1);
    for (int worker = 1; worker < wanted; ++worker)
        workers_.emplace_back([this, worker] { work(worker); });
}

ThreadPool::~ThreadPool() {
    stopping_ = true;
    start_workers();
    for (std::thread& worker : workers_)
        worker.join();
}

void ThreadPool::run(std::size_t count, const std::function<void(std::size_t, int)>& body) {
    Loop* const loop = workers_.empty() || count <= 1 ? nullptr : free_loop();
    if (loop == nullptr) {
        for (std::size_t index = 0; index < count; ++index)
            body(index, 0);
        return;
    }
    Kept kept(body);
    const std::function<void(std::size_t, int)> kept_body = [&kept](std::size_t index, int worker) {
        kept.call(index, worker);
    };
    loop->body = &kept_body;
    loop->count = count;
    loop->next = 0;
    loop->workers_inside.store(0, std::memory_order_release);
    start_workers();
    loop->take_indices(0);
    unsigned inside = loop->workers_inside.fetch_or(kClosed, std::memory_order_acq_rel) | kClosed;
    for (; inside != kClosed; inside = loop->workers_inside.load(std::memory_order_acquire))
        wait_while(loop->workers_inside, inside);
    loop->taken.store(false, std::memory_order_release);
    kept.throw_what_was_thrown();
}

/// Null when there is none.
ThreadPool::Loop* ThreadPool::free_loop() {
    for (Loop& loop : loops_)
        if (!loop.taken.load(std::memory_order_relaxed) &&
            !loop.taken.exchange(true, std::memory_order_acquire))
            return &loop;
    return nullptr;
}

void ThreadPool::start_workers() {
    generation_.fetch_add(1, std::memory_order_release);
    generation_.notify_all();
}

void ThreadPool::work(int worker) {
    int nice = 0;
    for (unsigned seen_generation = 0;;) {
        wait_while(generation_, seen_generation);
        seen_generation = generation_.load(std::memory_order_acquire);
        if (stopping_) return;
        if (nice != nice_) core::lower_priority(nice = nice_);
        for (Loop& loop : loops_)
            loop.help(worker);
    }
}

void ThreadPool::Loop::help(int worker) {
    if (!enter()) return;
    take_indices(worker);
    if (workers_inside.fetch_sub(1, std::memory_order_acq_rel) == (kClosed | 1U))
        workers_inside.notify_one();
}

bool ThreadPool::Loop::enter() {
    unsigned inside = workers_inside.load(std::memory_order_acquire);
    while ((inside & kClosed) == 0)
        if (workers_inside.compare_exchange_weak(inside, inside + 1, std::memory_order_acq_rel,
                                                 std::memory_order_acquire))
            return true;
    return false;
}

void ThreadPool::Loop::take_indices(int worker) {
    for (std::size_t index = next++; index < count; index = next++)
        (*body)(index, worker);
}

}  // namespace pastoso::core

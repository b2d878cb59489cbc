#include "core/thread_pool.hpp"

#include <algorithm>

#include "core/check.hpp"

namespace pastoso::core {

ThreadPool::ThreadPool(int thread_count) {
    PASTOSO_CHECK_OP(thread_count, >=, 0);
    const int wanted =
        thread_count > 0 ? thread_count : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    workers_.reserve(wanted - 1);
    for (int worker = 1; worker < wanted; ++worker) workers_.emplace_back([this, worker] { work(worker); });
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    work_ready_.notify_all();
    for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::run(std::size_t count, const std::function<void(std::size_t, int)>& body) {
    if (workers_.empty() || count <= 1) {
        for (std::size_t index = 0; index < count; ++index) body(index, 0);
        return;
    }
    {
        const std::lock_guard lock(mutex_);
        body_ = &body;
        count_ = count;
        next_ = 0;
        busy_workers_ = static_cast<int>(workers_.size());
        ++generation_;
    }
    work_ready_.notify_all();
    take_indices(0);
    std::unique_lock lock(mutex_);
    work_done_.wait(lock, [this] { return busy_workers_ == 0; });
    body_ = nullptr;
}

void ThreadPool::work(int worker) {
    unsigned long seen_generation = 0;
    for (;;) {
        {
            std::unique_lock lock(mutex_);
            work_ready_.wait(lock, [&] { return stopping_ || generation_ != seen_generation; });
            if (stopping_) return;
            seen_generation = generation_;
        }
        take_indices(worker);
        const std::lock_guard lock(mutex_);
        if (--busy_workers_ == 0) work_done_.notify_one();
    }
}

void ThreadPool::take_indices(int worker) {
    for (std::size_t index = next_++; index < count_; index = next_++) (*body_)(index, worker);
}

}  // namespace pastoso::core

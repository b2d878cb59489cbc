#include "core/background_thread.hpp"

#include "core/thread.hpp"

#include <utility>

namespace pastoso::core {
namespace {

/// A quarter of a processor beside a thread that wants all of it.
constexpr int kNice = 6;

}  // namespace

BackgroundThread::~BackgroundThread() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        jobs_.clear();
        stopping_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void BackgroundThread::add(std::function<void()> job) {
    {
        const std::lock_guard lock(mutex_);
        jobs_.push_back(std::move(job));
    }
    changed_.notify_all();
    if (!thread_.joinable()) thread_ = std::thread([this] { work(); });
}

BackgroundThread::Hold::~Hold() {
    --thread_.holds_;
    thread_.holds_.notify_all();
}

void BackgroundThread::rest_while_held() const {
    for (int holds = holds_; holds > 0; holds = holds_)
        holds_.wait(holds);
}

/// A job whose outcome somebody needs is done again by who needs it: what it throws here is thrown there
/// too.
void BackgroundThread::work() {
    lower_priority(kNice);
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return stopping_ || !jobs_.empty(); });
        if (stopping_) return;
        std::function<void()> job = std::move(jobs_.front());
        jobs_.pop_front();
        lock.unlock();
        fault_of(job);
        job = nullptr;
        lock.lock();
    }
}

}  // namespace pastoso::core

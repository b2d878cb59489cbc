// Jobs of one kind, done one at a time on a thread of their own.
#pragma once

#include "core/thread.hpp"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace pastoso::core {

/// Any thread may give it jobs. Its thread starts with the first. Jobs that have not begun when it goes
/// are dropped, and the one under way is cancelled and waited for. Declare it as the last member of its
/// owner: jobs use the others.
template <class Job>
class Worker {
  public:
    /// Does a job, on the worker's thread.
    using Work = std::function<void(Job& job)>;
    /// Is told there in one sentence what a job threw; the next one follows.
    using Failed = std::function<void(Job& job, const Message& sentence)>;

    /// `nice` as lower_priority() takes it.
    Worker(Work work, Failed failed, int nice = 0)
        : work_(std::move(work)), failed_(std::move(failed)), nice_(nice) {}
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// A queue: the job follows those that wait.
    void add(Job job) {
        change([&](std::deque<Job>& waiting) { waiting.push_back(std::move(job)); });
    }

    /// The latest wins: the job takes the place of those that wait.
    void replace(Job job) {
        change([&](std::deque<Job>& waiting) {
            waiting.clear();
            waiting.push_back(std::move(job));
        });
    }

    /// Anything in between: `make(waiting)` changes the jobs that wait, the next one in front. The
    /// worker is locked meanwhile.
    template <class Make>
    void change(const Make& make);

    /// Those that wait are not done any more.
    void drop() {
        change([](std::deque<Job>& waiting) { waiting.clear(); });
    }

    /// The same, and the job under way is asked to end early.
    void cancel();

    /// For the job under way, now and then: whether it is asked to end.
    bool cancelled() const { return cancelled_; }

    /// Whether a job waits or is under way.
    bool busy() const;

    /// Until none does. Not from within a job.
    void wait();

  private:
    void run();

    const Work work_;
    const Failed failed_;
    const int nice_;
    mutable std::mutex mutex_;
    std::condition_variable changed_, ended_;
    std::deque<Job> waiting_;
    bool under_way_ = false, ending_ = false;
    std::atomic<bool> cancelled_ = false;
    Thread thread_;
};

template <class Job>
Worker<Job>::~Worker() {
    {
        const std::lock_guard lock(mutex_);
        waiting_.clear();
        ending_ = cancelled_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

template <class Job>
template <class Make>
void Worker<Job>::change(const Make& make) {
    {
        const std::lock_guard lock(mutex_);
        make(waiting_);
        if (!waiting_.empty() && !thread_.exists())
            thread_ = Thread([this] { run(); }, [](const Message&) {});
    }
    changed_.notify_all();
    ended_.notify_all();
}

template <class Job>
void Worker<Job>::cancel() {
    {
        const std::lock_guard lock(mutex_);
        waiting_.clear();
        cancelled_ = under_way_;
    }
    ended_.notify_all();
}

template <class Job>
bool Worker<Job>::busy() const {
    const std::lock_guard lock(mutex_);
    return under_way_ || !waiting_.empty();
}

template <class Job>
void Worker<Job>::wait() {
    std::unique_lock lock(mutex_);
    ended_.wait(lock, [this] { return !under_way_ && waiting_.empty(); });
}

/// A job goes before it counts as done: whoever waits for it finds what it held free.
template <class Job>
void Worker<Job>::run() {
    if (nice_ > 0) lower_priority(nice_);
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
        if (ending_) return;
        std::optional<Job> job(std::move(waiting_.front()));
        waiting_.pop_front();
        under_way_ = true;
        cancelled_ = false;
        lock.unlock();
        guarded([&] { work_(*job); }, [&](const Message& sentence) { failed_(*job, sentence); });
        job.reset();
        lock.lock();
        under_way_ = false;
        ended_.notify_all();
    }
}

}  // namespace pastoso::core

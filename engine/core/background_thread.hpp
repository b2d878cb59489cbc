// A thread for work that can wait.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace pastoso::core {

/// Lowers the priority of the calling thread and of those that it starts, by up to 19; on Linux, threads
/// have priorities of their own.
void lower_priority(int nice);

/// Does jobs one after the other. Nobody should wait for them: they may take long to begin. One thread
/// may use it.
class BackgroundThread {
  public:
    BackgroundThread() = default;
    /// Waits for the job under way; those that have not begun are dropped.
    ~BackgroundThread();
    BackgroundThread(const BackgroundThread&) = delete;
    BackgroundThread& operator=(const BackgroundThread&) = delete;

    /// The job must not throw.
    void add(std::function<void()> job);

    /// While there is one, jobs rest where they ask: what somebody waits for needs the processors. Any
    /// thread may have one.
    class Hold {
      public:
        explicit Hold(BackgroundThread& thread) : thread_(thread) { ++thread_.holds_; }
        ~Hold();
        Hold(const Hold&) = delete;
        Hold& operator=(const Hold&) = delete;

      private:
        BackgroundThread& thread_;
    };
    /// For jobs that take long, now and then: returns when nobody holds the thread.
    void rest_while_held() const;

  private:
    void work();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::function<void()>> jobs_;
    bool stopping_ = false;
    std::atomic<int> holds_ = 0;
    std::thread thread_;  ///< started with the first job
};

}  // namespace pastoso::core

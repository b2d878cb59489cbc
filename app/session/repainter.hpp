// Paints a painting again on finer or coarser cells, beside the one on the easel.
#pragma once

#include "core/thread.hpp"
#include "document/painting.hpp"
#include "project/repainting.hpp"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

namespace pastoso::session {

class Repainter {
  public:
    using Notify = std::function<void()>;

    struct Status {
        double done = 0.0;   ///< 0 to 1, of the painting's ticks
        double spent_s = 0;  ///< without pauses
        bool paused = false;
        core::Message error{};  ///< why it cannot go on; one sentence
    };

    /// Begins at once, on the canvas of the strokes, with what processor time the painting on the easel
    /// leaves. `name` stands for the painting in sentences. `notify` is called on the repainter's thread
    /// when there is something new to show; it must return at once, and ask nothing of the repainter.
    Repainter(document::Recording strokes, std::string name, Notify notify);
    /// Gives up what is not painted yet, and waits for the tick that it is at.
    ~Repainter();
    Repainter(const Repainter&) = delete;
    Repainter& operator=(const Repainter&) = delete;

    /// Nothing is told once this has returned; the tick that it is at is not waited for.
    void cancel();

    void set_paused(bool paused);

    Status status() const;
    std::shared_ptr<const document::Snapshot> snapshot() const;  ///< null before the first
    std::shared_ptr<const project::Project> painted() const;     ///< null before the end

  private:
    using Clock = std::chrono::steady_clock;

    void run();
    void fail(const core::Message& sentence);
    void tell();
    bool goes_on(double done);
    void publish(const document::Painting& painting);

    const document::Recording strokes_;
    const std::string name_;
    const Notify notify_;
    Clock::time_point published_at_{};  ///< of the thread alone

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    Status status_;
    Clock::time_point counted_at_{};
    std::shared_ptr<const document::Snapshot> snapshot_;
    std::shared_ptr<const project::Project> painted_;
    bool stopping_ = false;
    core::Thread thread_;
};

}  // namespace pastoso::session

// What takes a while is read or made beside the window, which stays alive: how far it is stands in the
// status line, with a button to give it up.
#pragma once

#include "core/progress.hpp"
#include "core/worker.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include <QObject>
#include <QString>
#include <QTimer>

namespace pastoso::panels {
class WorkProgress;
}

namespace pastoso::main {

class Studio;

/// One work at a time. All is to be called on the window's thread.
class Loading : public QObject {
    Q_OBJECT
  public:
    /// Takes over what was made, on the window's thread. It is dropped, on any thread, where nobody
    /// wants it any more.
    using TakeOver = std::function<void()>;

    /// Makes it, on a thread of its own; what it throws is told in one sentence.
    using Make = std::function<TakeOver(const core::Progress& progress)>;

    explicit Loading(Studio& studio);

    /// Until it was taken over, or came to nothing.
    bool busy() const { return wanted_ != 0; }

    /// Begins a work that the painter knows by these words, in place of the one under way: what is
    /// wished for last counts. It is taken over as soon as the hand rests and no question is open.
    void replace(const QString& words, Make make);

    /// The same, but not while another one is under way, which is told.
    void begin(const QString& words, Make make);

    /// Gives up the work under way, if there is any. All stays as it is.
    void cancel();

    /// From now on told on the work's thread how far it is, before anything else comes of that.
    void watch(core::Progress watcher) { watcher_ = std::move(watcher); }

  Q_SIGNALS:
    void failed(const QString& sentence);  ///< and the message stands already
    void ended();                          ///< whatever became of it

  private:
    struct Job {
        std::uint64_t number = 0;
        Make make;
    };
    struct Made {
        TakeOver take_over;
        core::Message fault{};
    };

    void make(Job& job);
    void hand_over(std::uint64_t number, Made made);
    void take();
    void end();
    void fail(const core::Message& fault);
    bool hand_rests() const;

    Studio& studio_;
    panels::WorkProgress* progress_ = nullptr;
    QString words_;
    QTimer look_;
    std::atomic<double> done_ = 0.0;
    core::Progress watcher_;
    std::uint64_t begun_ = 0;
    std::mutex mutex_;
    std::uint64_t wanted_ = 0;  ///< changed under the lock by the window alone; 0: none
    std::optional<Made> made_;
    core::Worker<Job> worker_;  ///< the last: it ends before what it works with
};

}  // namespace pastoso::main

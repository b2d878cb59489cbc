// A liquid that lives on its own thread: the window says what is done to it and shows the moments that
// are published. What the glass of tea and the tank have in common. Nothing here knows of widgets.
#pragma once

#include "core/thread.hpp"
#include "core/thread_pool.hpp"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::session {

struct LiquidStatus {
    int glass = 0;                ///< counts the new ones
    int step = 0, last_step = 0;  ///< shown, and reached
    double time_s = 0.0, last_s = 0.0;
    bool paused = false;
    bool full_speed = false;
    bool shows_last = true;
    double steps_per_s = 0.0;    ///< in about the last second
    std::vector<int> kept;       ///< steps that can be shown
    std::size_t kept_bytes = 0;  ///< what they take
    bool busy = false;           ///< a glass is being made
};

/// Actions are applied in their order, each between two steps. The hand never waits for a step.
class LiquidSession {
  public:
    using Notify = std::function<void()>;

    static constexpr std::size_t kBudget_bytes = std::size_t{256} << 20;

    virtual ~LiquidSession();
    LiquidSession(const LiquidSession&) = delete;
    LiquidSession& operator=(const LiquidSession&) = delete;

    /// Going on shows the last step.
    void set_paused(bool paused);

    /// Time passes as fast as it can be computed, otherwise at most as fast as on the wall.
    void set_full_speed(bool full);

    /// Lets exactly so many steps pass, as fast as they are computed, and pauses. What is said
    /// afterwards holds after them. A liquid that waits lets fewer pass.
    void advance(int steps);

    /// Shows the kept moment at or before that step, and pauses.
    void show(int step);

    /// What was refused or failed since the last call, a sentence each. Where a step or its picture
    /// failed, time has stopped.
    std::vector<core::Message> take_errors();

    /// Waits until what was said before is applied and published.
    void wait_until_applied();

  protected:
    struct Action {
        std::function<void()> apply;  ///< what it throws is told as refused
        bool makes_glass = false;
        bool waits_for_step = false;  ///< while a step is owed to what was said before
    };

    /// `notify` is called on the session's thread when there is something new; it must return at once.
    LiquidSession(bool paused, Notify notify);

    /// The thread: from the end of a constructor to the beginning of a destructor.
    void begin();
    void end();

    void post(Action action);
    std::mutex& mutex() const { return mutex_; }
    const LiquidStatus& status_locked() const { return status_; }

    // What a liquid says to its own thread.
    virtual bool has_liquid() const = 0;
    /// Returns the seconds that passed in the liquid.
    virtual double step_liquid() = 0;
    virtual bool owes_step() const { return false; }
    /// No step is made until something else is said.
    virtual bool waits() const { return false; }
    virtual int last_step() const = 0;
    /// Makes what is to be shown, and says its step, times and what is kept. Only with a liquid.
    virtual void make_moment(LiquidStatus& status) = 0;
    /// Lets others see it, under the mutex.
    virtual void give_moment() = 0;

    // Of the session's thread alone.
    core::ThreadPool& pool() { return pool_; }
    bool paused() const { return paused_; }
    std::optional<int> shown_step() const { return shown_step_; }  ///< none: the last
    void show_last() { shown_step_.reset(); }
    /// Another liquid is there: it begins now.
    void glass_made();

  private:
    using Clock = std::chrono::steady_clock;

    void run();
    void work();
    void refuse(const core::Message& sentence);
    void stop_at_fault(const core::Message& sentence);
    bool wait_for_work();
    bool apply_next();
    void step();
    bool runs() const { return has_liquid() && !paused_ && !waits(); }
    bool may_wait() const;
    bool is_ending() const;
    void publish();

    const Notify notify_;

    core::ThreadPool pool_;
    int glass_ = 0;
    bool paused_, full_speed_ = false;
    std::optional<int> shown_step_;
    bool changed_ = false;
    Clock::time_point due_, published_at_, stepped_at_;
    Clock::duration publication_cost_{};
    double steps_per_s_ = 0.0;

    mutable std::mutex mutex_;
    std::condition_variable work_, published_;
    std::deque<Action> posted_;
    std::vector<core::Message> errors_;
    LiquidStatus status_;
    std::uint64_t posted_count_ = 0, applied_count_ = 0, published_count_ = 0;
    bool stopping_ = false;
    core::Thread thread_;
};

}  // namespace pastoso::session

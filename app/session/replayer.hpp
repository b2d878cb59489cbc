// Paints a recording once more on a canvas of its own, to be watched: faster than it was painted,
// stopped, and sought back and forth.
#pragma once

#include "core/thread.hpp"
#include "core/thread_pool.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/player.hpp"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::session {

/// As fast as it can be computed.
inline constexpr double kFullSpeed = 0.0;

class Replayer {
  public:
    using Notify = std::function<void()>;

    struct Status {
        std::int64_t tick = 0, end_tick = 0;
        bool playing = false;  ///< goes on by itself
        bool seeking = false;  ///< is on its way to where it was sent
        core::Message error{};  ///< why it cannot go on; one sentence
        friend bool operator==(const Status&, const Status&) = default;
    };

    /// Starts to play. `notify` is called on the replayer's thread when there is something new to show;
    /// it must return at once.
    Replayer(document::Recording recording, Notify notify);
    ~Replayer();
    Replayer(const Replayer&) = delete;
    Replayer& operator=(const Replayer&) = delete;

    /// At the end it begins anew.
    void set_playing(bool playing);

    /// Seconds of painting in a second, or kFullSpeed.
    void set_speed(double speed);

    /// Shows the painting as it was then, and goes on from there as before.
    void seek(std::int64_t tick);

    std::shared_ptr<const document::Snapshot> snapshot() const;  ///< null before the first
    Status status() const;

  private:
    using Clock = std::chrono::steady_clock;

    struct Kept {
        document::PaintingState state;
        std::size_t next_event = 0;
    };

    void run();
    void fail(const core::Message& sentence);
    bool wait_for_work();
    void step();
    void begin(std::int64_t tick);
    const Kept* kept_before(std::int64_t tick) const;
    void keep_state();
    void play_tick();
    bool is_there(std::int64_t tick) const;
    void arrive(std::int64_t tick);
    void end();
    void publish(const std::function<void()>& settle = [] {});
    void publish_if_due();

    const document::Recording recording_;
    const Notify notify_;

    // Of the replayer's thread alone.
    core::ThreadPool pool_;
    std::vector<Kept> kept_;  ///< to go back to, the oldest first
    std::unique_ptr<document::Painting> painting_;
    document::Recording rest_;  ///< what the player plays
    std::unique_ptr<document::Player> player_;
    Clock::time_point published_at_;

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    Status status_;
    double speed_ = 1.0;
    Clock::time_point due_;  ///< the next tick
    std::optional<std::int64_t> target_;
    std::shared_ptr<const document::Snapshot> snapshot_;
    bool stopping_ = false;
    core::Thread thread_;
};

}  // namespace pastoso::session

// How long the painter waits: from the hand to the painting that shows it, and to the screen.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::session {

/// Seconds that something took, each time.
struct Durations {
    std::vector<double> all_s;

    /// So large that `share` (0 to 1) of them are not larger, by the nearest rank; 0 when there are
    /// none.
    double percentile_s(double share) const;
};

/// Collects them while the program runs. Any thread may tell it anything.
class FrameTimes {
  public:
    using Clock = std::chrono::steady_clock;

    /// The program hears now what a device's own clock, in milliseconds, says when it happened. What is
    /// posted next came of it. The clocks are compared by the event that was heard soonest.
    void heard(double device_ms, Clock::time_point now);

    /// The hand has done so much; in the order of the session. It happened when it was heard of, or now.
    void posted(Clock::time_point now);
    /// `count` of what was posted first and not published yet is in this snapshot.
    void published(std::uint64_t count, const void* snapshot, Clock::time_point now);
    /// All that was posted until now has a mark in the frame that comes next.
    void marked();
    /// A frame has come to the screen that shows this snapshot, and what is in those before it; they
    /// never will be shown.
    void presented(const void* snapshot, Clock::time_point now);
    /// A tick in which no paint was wet cost the session so much.
    void quiet_tick(double seconds);

    Durations event_to_snapshot() const;
    /// To its mark, or to itself where that is sooner.
    Durations event_to_mark() const;
    Durations event_to_screen() const;
    Durations snapshot_to_screen() const;
    Durations quiet_ticks() const;

    /// A table of them with their percentiles in milliseconds.
    std::string table() const;

  private:
    void see(std::size_t count, Clock::time_point now);

    struct Published {
        const void* snapshot;
        Clock::time_point time;
        std::vector<Clock::time_point> events;  ///< that are in it first
    };

    mutable std::mutex mutex_;
    std::deque<Clock::time_point> posted_;
    std::deque<Published> published_;
    std::deque<Clock::time_point> unseen_;  ///< of all events, those without a mark on the screen
    std::size_t marked_ = 0;                ///< of those, in the frame that comes next
    std::optional<Clock::duration> device_behind_;  ///< this clock less the device's
    std::optional<Clock::time_point> heard_;
    Durations event_to_snapshot_, event_to_mark_, event_to_screen_, snapshot_to_screen_, quiet_ticks_;
};

}  // namespace pastoso::session

// How long the painter waits: from the hand to the painting that shows it, and from there to the screen.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <mutex>
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

    /// The hand has done so much; in the order of the session.
    void posted(Clock::time_point now);
    /// `count` of what was posted first and not published yet is in this snapshot.
    void published(std::uint64_t count, const void* snapshot, Clock::time_point now);
    /// The screen shows this snapshot; those before it never will be.
    void presented(const void* snapshot, Clock::time_point now);
    /// A tick in which no paint was wet cost the session so much.
    void quiet_tick(double seconds);

    Durations event_to_snapshot() const;
    Durations snapshot_to_screen() const;
    Durations quiet_ticks() const;

    /// A table of the three with their percentiles in milliseconds.
    std::string table() const;

  private:
    struct Published {
        const void* snapshot;
        Clock::time_point time;
    };

    mutable std::mutex mutex_;
    std::deque<Clock::time_point> posted_;
    std::deque<Published> published_;
    Durations event_to_snapshot_, snapshot_to_screen_, quiet_ticks_;
};

}  // namespace pastoso::session

#include "session/frame_times.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace pastoso::session {
namespace {

double seconds(FrameTimes::Clock::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

std::string row(const char* name, const Durations& durations) {
    const auto ms = [&](double share) { return 1000.0 * durations.percentile_s(share); };
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(), "%-20s %8zu %9.2f %9.2f %9.2f %9.2f\n", name,
                  durations.all_s.size(), ms(0.5), ms(0.95), ms(0.99), ms(1.0));
    return text.data();
}

}  // namespace

double Durations::percentile_s(double share) const {
    PASTOSO_CHECK(share >= 0.0 && share <= 1.0);
    if (all_s.empty()) return 0.0;
    std::vector<double> sorted = all_s;
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
    const auto place = sorted.begin() + static_cast<std::ptrdiff_t>(rank > 0 ? rank - 1 : 0);
    std::nth_element(sorted.begin(), place, sorted.end());
    return *place;
}

void FrameTimes::heard(double device_ms, Clock::time_point now) {
    const auto device = std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double, std::milli>(device_ms));
    const Clock::duration behind = now.time_since_epoch() - device;
    const std::lock_guard lock(mutex_);
    device_behind_ = std::min(device_behind_.value_or(behind), behind);
    heard_ = Clock::time_point(device + *device_behind_);
}

void FrameTimes::posted(Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    posted_.push_back(std::exchange(heard_, std::nullopt).value_or(now));
    unseen_.push_back(posted_.back());
}

void FrameTimes::published(std::uint64_t count, const void* snapshot, Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    Published published{snapshot, now, {}};
    for (; count > 0 && !posted_.empty(); --count) {
        event_to_snapshot_.all_s.push_back(seconds(now - posted_.front()));
        published.events.push_back(posted_.front());
        posted_.pop_front();
    }
    published_.push_back(std::move(published));
}

void FrameTimes::marked() {
    const std::lock_guard lock(mutex_);
    marked_ = unseen_.size();
}

/// The lock is held.
void FrameTimes::see(std::size_t count, Clock::time_point now) {
    for (; count > 0; --count) {
        event_to_mark_.all_s.push_back(seconds(now - unseen_.front()));
        unseen_.pop_front();
    }
}

void FrameTimes::presented(const void* snapshot, Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    see(std::exchange(marked_, 0), now);
    const auto shown =
        std::find_if(published_.begin(), published_.end(),
                     [snapshot](const Published& other) { return other.snapshot == snapshot; });
    if (shown == published_.end()) return;
    snapshot_to_screen_.all_s.push_back(seconds(now - shown->time));
    for (auto each = published_.begin(); each <= shown; ++each)
        for (const Clock::time_point event : each->events)
            event_to_screen_.all_s.push_back(seconds(now - event));
    published_.erase(published_.begin(), shown + 1);
    std::size_t coming = posted_.size();
    for (const Published& later : published_)
        coming += later.events.size();
    if (unseen_.size() > coming) see(unseen_.size() - coming, now);
}

void FrameTimes::quiet_tick(double seconds) {
    const std::lock_guard lock(mutex_);
    quiet_ticks_.all_s.push_back(seconds);
}

Durations FrameTimes::event_to_snapshot() const {
    const std::lock_guard lock(mutex_);
    return event_to_snapshot_;
}

Durations FrameTimes::event_to_mark() const {
    const std::lock_guard lock(mutex_);
    return event_to_mark_;
}

Durations FrameTimes::event_to_screen() const {
    const std::lock_guard lock(mutex_);
    return event_to_screen_;
}

Durations FrameTimes::snapshot_to_screen() const {
    const std::lock_guard lock(mutex_);
    return snapshot_to_screen_;
}

Durations FrameTimes::quiet_ticks() const {
    const std::lock_guard lock(mutex_);
    return quiet_ticks_;
}

std::string FrameTimes::table() const {
    return "ms                      count    median       95%       99%   longest\n" +
           row("event to snapshot", event_to_snapshot()) + row("event to mark", event_to_mark()) +
           row("event to screen", event_to_screen()) + row("snapshot to screen", snapshot_to_screen()) +
           row("tick without paint", quiet_ticks());
}

}  // namespace pastoso::session

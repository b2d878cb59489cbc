#include "tools/event_rate.hpp"

namespace pastoso::tools {
namespace {

constexpr std::uint64_t kSeen_ms = 500;

}  // namespace

/// A clock that runs back starts anew, and so does a hand that comes back after a rest.
void EventRate::note(std::uint64_t time_ms) {
    if (!times_ms_.empty() && time_ms < times_ms_.back()) times_ms_.clear();
    while (!times_ms_.empty() && time_ms - times_ms_.front() > kSeen_ms)
        times_ms_.pop_front();
    times_ms_.push_back(time_ms);
}

double EventRate::hertz() const {
    if (times_ms_.size() < 2 || times_ms_.back() == times_ms_.front()) return 0.0;
    const auto intervals = static_cast<double>(times_ms_.size() - 1);
    return 1000.0 * intervals / static_cast<double>(times_ms_.back() - times_ms_.front());
}

}  // namespace pastoso::tools

#include "brush/strips.hpp"

#include <algorithm>
#include <cmath>
#include <thread>

namespace pastoso::brush {
namespace {

/// Least width of a strip, in footprint radii: two would do, more leaves few elements waiting.
constexpr double kLeastWidth_radii = 4.0;
/// Distance below which footprints may share cells, in radii, with room for rounding.
constexpr double kMeeting_radii = 2.001;
/// How often a thread looks for an element that may act before it lets others have its processor.
constexpr int kLooksBeforeYielding = 1000;

void wait_briefly(int looks) {
    if (looks % kLooksBeforeYielding == 0) std::this_thread::yield();
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

}  // namespace

void Strips::divide(const std::vector<StripPlace>& places, double radius_mm, int most_strips) {
    const auto by_side = [](const StripPlace& a, const StripPlace& b) { return a.side_mm < b.side_mm; };
    const auto [low, high] = std::minmax_element(places.begin(), places.end(), by_side);
    const double low_mm = places.empty() ? 0.0 : low->side_mm;
    const double width_mm = places.empty() ? 0.0 : high->side_mm - low_mm;
    const double wide_enough = std::floor(width_mm / (kLeastWidth_radii * radius_mm));
    count_ = std::max(1, static_cast<int>(std::min<double>(most_strips, wide_enough)));
    meeting_mm_ = kMeeting_radii * radius_mm;
    while (static_cast<int>(strips_.size()) < count_)
        strips_.emplace_back();
    for (int s = 0; s < count_; ++s) {
        Strip& strip = strips_[s];
        strip.turns.clear();
        strip.at_low_side.clear();
        strip.at_high_side.clear();
        strip.hindered = false;
        strip.done.store(0, std::memory_order_relaxed);
    }
    const double strip_mm = width_mm / count_;
    for (const StripPlace& place : places) {
        const double across = count_ > 1 ? (place.side_mm - low_mm) / strip_mm : 0.0;
        const int strip = std::min(static_cast<int>(across), count_ - 1);
        append(place, strip, low_mm + strip * strip_mm, low_mm + (strip + 1) * strip_mm);
    }
    strips_left_ = static_cast<int>(std::count_if(strips_.begin(), strips_.begin() + count_,
                                                  [](const Strip& s) { return !s.turns.empty(); }));
}

void Strips::append(const StripPlace& place, int strip, double low_mm, double high_mm) {
    Strip& own = strips_[strip];
    const int turn = static_cast<int>(own.turns.size());
    int after_low = 0, after_high = 0;
    if (strip > 0 && place.side_mm - low_mm < meeting_mm_) {
        after_low = turns_before(strips_[strip - 1].at_high_side, place);
        own.at_low_side.push_back({turn, place.x_mm, place.y_mm});
    }
    if (strip + 1 < count_ && high_mm - place.side_mm < meeting_mm_) {
        after_high = turns_before(strips_[strip + 1].at_low_side, place);
        own.at_high_side.push_back({turn, place.x_mm, place.y_mm});
    }
    own.turns.push_back({place.element, after_low, after_high});
}

int Strips::turns_before(const std::vector<Neighbour>& beyond, const StripPlace& place) const {
    const auto meets = [&](const Neighbour& other) {
        return std::hypot(other.x_mm - place.x_mm, other.y_mm - place.y_mm) < meeting_mm_;
    };
    const auto last = std::find_if(beyond.rbegin(), beyond.rend(), meets);
    return last == beyond.rend() ? 0 : last->turn + 1;
}

bool Strips::run(core::ThreadPool* pool, const Act& act) {
    halted_ = false;
    for (int s = 0; s < count_; ++s)
        strips_[s].hindered = false;
    if (count_ == 1) {
        work(0, act);
    } else {
        pool->run(static_cast<std::size_t>(count_),
                  [&](std::size_t strip, int) { work(static_cast<int>(strip), act); });
    }
    return strips_left_ == 0;
}

std::vector<int> Strips::hindered() const {
    std::vector<int> strips;
    for (int s = 0; s < count_; ++s) {
        if (strips_[s].hindered) strips.push_back(s);
    }
    return strips;
}

/// Own strip first, so that cells stay with a thread; whoever has nothing to do there helps in another,
/// so that a strip gets done even if no thread comes for it.
void Strips::work(int first_strip, const Act& act) {
    int looks = 0;
    for (int s = first_strip; strips_left_ > 0 && !halted_; s = (s + 1) % count_) {
        Strip& strip = strips_[s];
        const bool free = !strip.taken.load(std::memory_order_relaxed) && may_act(s);
        if (!free || strip.taken.exchange(true, std::memory_order_acquire)) {
            wait_briefly(++looks);
            continue;
        }
        advance(s, act);
        strip.taken.store(false, std::memory_order_release);
    }
}

bool Strips::may_act(int strip) const {
    const Strip& own = strips_[strip];
    const auto next = static_cast<std::size_t>(own.done.load(std::memory_order_acquire));
    if (next == own.turns.size()) return false;
    const Turn& turn = own.turns[next];
    const auto has_done = [&](int other, int count) {
        return count == 0 || strips_[other].done.load(std::memory_order_acquire) >= count;
    };
    return has_done(strip - 1, turn.after_low) && has_done(strip + 1, turn.after_high);
}

void Strips::advance(int strip, const Act& act) {
    Strip& own = strips_[strip];
    while (!halted_.load(std::memory_order_relaxed) && may_act(strip)) {
        const int next = own.done.load(std::memory_order_relaxed);
        if (!act(own.turns[next].element, strip)) {
            own.hindered = true;
            halted_ = true;
            return;
        }
        own.done.store(next + 1, std::memory_order_release);
        if (next + 1 == static_cast<int>(own.turns.size())) --strips_left_;
    }
}

}  // namespace pastoso::brush

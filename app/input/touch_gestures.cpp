#include "input/touch_gestures.hpp"

#include <algorithm>
#include <utility>

#include <QLineF>

namespace pastoso::input {
namespace {

/// A finger that has moved by less may still be the first of two, or tap.
constexpr double kStill_px = 8.0;

constexpr std::uint64_t kTap_ms = 350;

double distance(const QPointF& a, const QPointF& b) {
    return QLineF(a, b).length();
}

TouchStep at(TouchStep::Does does, const QPointF& place) {
    return {.does = does, .place = place, .from = {}, .to = {}};
}

}  // namespace

std::vector<TouchStep> TouchGestures::follow(const std::vector<Finger>& down, std::uint64_t time_ms,
                                             bool yields) {
    if (down.empty()) return lift(time_ms);
    if (does_ == Does::Start) {
        does_ = Does::Wait;
        from_ = last_ = down.front().place;
        began_ms_ = time_ms;
    }
    most_ = std::max(most_, static_cast<int>(down.size()));
    if (down.size() >= 2) return pinch(down[0], down[1], yields);
    return work(down.front().place);
}

std::vector<TouchStep> TouchGestures::work(const QPointF& place) {
    if (does_ != Does::Wait && does_ != Does::Work) return {};
    if (does_ == Does::Wait && distance(place, from_) < kStill_px) return {};
    std::vector<TouchStep> steps;
    if (std::exchange(does_, Does::Work) == Does::Wait)
        steps.push_back(at(TouchStep::Does::Press, from_));
    last_ = place;
    steps.push_back(at(TouchStep::Does::Move, place));
    return steps;
}

std::vector<TouchStep> TouchGestures::pinch(const Finger& first, const Finger& second, bool yields) {
    std::vector<TouchStep> steps;
    if (does_ == Does::Nothing || (does_ == Does::Work && !yields)) return steps;
    if (does_ == Does::Work) steps.push_back(at(TouchStep::Does::Release, last_));
    const std::array ids{first.id, second.id};
    const std::array now{first.place, second.place};
    if (std::exchange(does_, Does::Pinch) != Does::Pinch || ids != ids_) {
        ids_ = ids;
        pinched_ = now;
        return steps;
    }
    const double way = std::max(distance(now[0], pinched_[0]), distance(now[1], pinched_[1]));
    if (!moved_ && way < kStill_px) return steps;
    moved_ = true;
    steps.push_back({.does = TouchStep::Does::Pinch, .place = {}, .from = pinched_, .to = now});
    pinched_ = now;
    return steps;
}

/// A finger that hardly moved leaves a touch of paint.
std::vector<TouchStep> TouchGestures::lift(std::uint64_t time_ms) {
    std::vector<TouchStep> steps;
    if (does_ == Does::Wait) steps.push_back(at(TouchStep::Does::Press, from_));
    if (does_ == Does::Wait || does_ == Does::Work) steps.push_back(at(TouchStep::Does::Release, last_));
    if (does_ == Does::Pinch && !moved_ && time_ms - began_ms_ <= kTap_ms)
        steps.push_back(
            {.does = TouchStep::Does::Tap, .place = {}, .from = {}, .to = {}, .fingers = most_});
    *this = {};
    return steps;
}

std::vector<TouchStep> TouchGestures::cancel() {
    std::vector<TouchStep> steps;
    if (does_ == Does::Work) steps.push_back(at(TouchStep::Does::Cancel, last_));
    *this = {};
    return steps;
}

}  // namespace pastoso::input

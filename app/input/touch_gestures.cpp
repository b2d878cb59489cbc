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

TouchStep by(TouchStep::Does does, const Finger& finger) {
    return {.does = does, .finger = finger};
}

/// Null when it has lifted.
const Finger* same(const Finger& finger, const std::vector<Finger>& down) {
    const auto found = std::ranges::find(down, finger.id, &Finger::id);
    return found == down.end() ? nullptr : &*found;
}

}  // namespace

std::vector<TouchStep> TouchGestures::follow(const std::vector<Finger>& down, std::uint64_t time_ms,
                                             bool yields) {
    if (down.empty()) return lift(time_ms);
    if (does_ == Does::Start) {
        does_ = Does::Wait;
        first_ = last_ = down.front();
        began_ms_ = time_ms;
    }
    most_ = std::max(most_, static_cast<int>(down.size()));
    const bool pinches = down.size() >= 2 && (does_ != Does::Work || yields);
    if (pinches) return pinch(down[0], down[1]);
    if (does_ != Does::Wait && does_ != Does::Work) return {};
    if (const Finger* finger = same(first_, down)) return work(*finger);
    return lift_first();
}

std::vector<TouchStep> TouchGestures::work(const Finger& finger) {
    if (does_ == Does::Wait && distance(finger.place, first_.place) < kStill_px) return {};
    if (does_ == Does::Work && finger.place == last_.place) return {};  // another one moved
    std::vector<TouchStep> steps;
    if (std::exchange(does_, Does::Work) == Does::Wait)
        steps.push_back(by(TouchStep::Does::Press, first_));
    last_ = finger;
    steps.push_back(by(TouchStep::Does::Move, finger));
    return steps;
}

/// One that hardly moved leaves a touch of paint. Others that are down have nothing to do.
std::vector<TouchStep> TouchGestures::lift_first() {
    std::vector<TouchStep> steps;
    if (does_ == Does::Wait) steps.push_back(by(TouchStep::Does::Press, first_));
    if (does_ == Does::Wait || does_ == Does::Work) steps.push_back(by(TouchStep::Does::Release, last_));
    does_ = Does::Nothing;
    return steps;
}

std::vector<TouchStep> TouchGestures::pinch(const Finger& first, const Finger& second) {
    std::vector<TouchStep> steps;
    if (does_ == Does::Nothing) return steps;
    if (does_ == Does::Work) steps.push_back(by(TouchStep::Does::Release, last_));
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
    steps.push_back({.does = TouchStep::Does::Pinch, .from = pinched_, .to = now});
    pinched_ = now;
    return steps;
}

std::vector<TouchStep> TouchGestures::lift(std::uint64_t time_ms) {
    const bool taps = does_ == Does::Pinch && !moved_ && time_ms - began_ms_ <= kTap_ms;
    std::vector<TouchStep> steps = lift_first();
    if (taps) steps.push_back({.does = TouchStep::Does::Tap, .fingers = most_});
    *this = {};
    return steps;
}

std::vector<TouchStep> TouchGestures::cancel() {
    std::vector<TouchStep> steps;
    if (does_ == Does::Work) steps.push_back(by(TouchStep::Does::Cancel, last_));
    *this = {};
    return steps;
}

}  // namespace pastoso::input

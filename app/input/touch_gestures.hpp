// What fingers on a screen mean: one does the work of a mouse, two move, turn and zoom the canvas, taps
// of two and three are commands.
#pragma once

#include "input/finger.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace pastoso::input {

struct TouchStep {
    enum class Does {
        Press,  ///< one finger
        Move,
        Release,
        Cancel,  ///< what it began was not meant
        Pinch,   ///< two go `from` there `to` here
        Tap,     ///< so many `fingers` at once
    } does;
    Finger finger{};
    std::array<QPointF, 2> from{}, to{};
    int fingers = 0;
};

/// Knows what the fingers do between the first that comes down and the last that lifts. One that hardly
/// moves waits: it may be the first of two, or be held. While one works, no other takes its place.
class TouchGestures {
  public:
    /// All fingers that are down after an event, and its moment. `yields`: what one finger does ends
    /// where a second one comes, which pinches with it.
    std::vector<TouchStep> follow(const std::vector<Finger>& down, std::uint64_t time_ms, bool yields);

    /// None of it was meant.
    std::vector<TouchStep> cancel();

    /// Whether one finger waits. A finger that has waited for kHold_ms is held.
    bool waits() const { return does_ == Does::Wait; }
    const QPointF& waits_at() const { return first_.place; }

    /// It has been held, which was all that it meant.
    void spend() { does_ = Does::Nothing; }

    static constexpr int kHold_ms = 600;

  private:
    enum class Does { Start, Wait, Work, Pinch, Nothing };

    std::vector<TouchStep> work(const Finger& finger);
    std::vector<TouchStep> lift_first();
    std::vector<TouchStep> pinch(const Finger& first, const Finger& second);
    std::vector<TouchStep> lift(std::uint64_t time_ms);

    Does does_ = Does::Start;
    Finger first_;  ///< where it came down
    Finger last_;   ///< where it was then
    std::uint64_t began_ms_ = 0;
    int most_ = 0;  ///< that were down at once
    std::array<int, 2> ids_{};
    std::array<QPointF, 2> pinched_{};
    bool moved_ = false;  ///< two of them
};

}  // namespace pastoso::input

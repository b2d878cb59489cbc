// Which of several devices the view listens to.
#pragma once

#include "input/pointer_event.hpp"

#include <cstdint>
#include <optional>

namespace pastoso::input {

/// A press belongs to its device until that lifts: no other one ends or bends what it does, but for a
/// pen, which takes the place of fingers. Fingers that come down beside a pen are the hand that holds
/// it.
class Arbiter {
  public:
    enum class Verdict {
        Hear,
        Ignore,
        TakeOver,  ///< hear it; what fingers do is cancelled
    };

    /// Of a mouse or a pen.
    Verdict judge(const PointerEvent& event);

    /// Whether fingers are heard, of which the first came down at this moment.
    bool hears_fingers(std::uint64_t began_ms);
    /// They do something, or all have lifted.
    void fingers_hold(bool hold);

  private:
    enum class Holder { Mouse, Pen, Fingers };

    std::optional<Holder> holder_;
    std::optional<std::uint64_t> pen_seen_ms_;
};

}  // namespace pastoso::input

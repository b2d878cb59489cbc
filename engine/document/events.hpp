// A painting as a list of what the painter did.
#pragma once

#include "document/actions/actions.hpp"
#include "document/arithmetic.hpp"
#include "document/canvas_settings.hpp"

#include <cstdint>
#include <vector>

namespace pastoso::document {

/// Paint time passes in ticks of this length; every event is applied between two ticks, so that a replay
/// gives the same bits as the session it was logged in.
inline constexpr double kTick_s = 1.0 / 60.0;

struct Event {
    std::int64_t tick = 0;  ///< the number of ticks that had passed when it happened
    Action action;
    friend bool operator==(const Event&, const Event&) = default;
};

struct Recording {
    CanvasSettings canvas;
    std::vector<Event> events;  ///< ticks do not decrease
    std::int64_t end_tick = 0;  ///< how long the paint is let run in all, >= the last event's tick
    int arithmetic = kArithmetic;  ///< the earliest that any of the events was computed with
    friend bool operator==(const Recording&, const Recording&) = default;
};

}  // namespace pastoso::document

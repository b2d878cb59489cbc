// The stroke log of a live session.
#pragma once

#include "document/events.hpp"
#include "document/packed_moves.hpp"

#include <cstddef>
#include <deque>

namespace pastoso::document {

/// Collects what is applied to a painting, so that the session can be saved and replayed to the same
/// bits. It grows as long as somebody paints, by what packed moves take (15 MiB in an hour of which a
/// pen that reports 200 times a second never leaves the canvas).
class Recorder {
  public:
    explicit Recorder(const CanvasSettings& canvas) : canvas_(canvas) {}
    /// Goes on with a session until its last tick.
    explicit Recorder(const Recording& past);

    /// To be called with Painting::tick() for every action that was applied; ticks do not decrease.
    void add(std::int64_t tick, const Action& action);

    /// So many ticks have passed.
    void note_tick(std::int64_t tick);

    /// The session until the last tick that was noted.
    Recording recording() const;

  private:
    struct Other {
        std::size_t moves_before = 0;
        Event event;
    };

    void append(const Event& event);

    CanvasSettings canvas_;
    std::int64_t end_tick_ = 0;
    PackedMoves moves_;
    std::deque<Other> others_;  ///< what is no move
};

}  // namespace pastoso::document

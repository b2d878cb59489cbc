// The stroke log of a live session.
#pragma once

#include "core/shared_log.hpp"
#include "document/events.hpp"
#include "document/packed_moves.hpp"

#include <cstddef>

namespace pastoso::document {

/// Collects what is applied to a painting, so that the session can be saved and replayed to the same
/// bits. It grows as long as somebody paints, by what packed moves take (15 MiB in an hour of which a
/// pen that reports 200 times a second never leaves the canvas). A copy is cheap, whatever it holds: it
/// can be taken between two ticks and read on another thread.
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

    const CanvasSettings& canvas() const { return canvas_; }
    std::int64_t end_tick() const { return end_tick_; }
    std::int64_t strokes() const { return strokes_; }
    /// Whether anything that was done changes the painting.
    bool changes_painting() const { return changes_painting_; }

  private:
    struct Other {
        std::size_t moves_before = 0;
        Event event;
    };

    void append(const Event& event);

    CanvasSettings canvas_;
    std::int64_t end_tick_ = 0;
    int arithmetic_ = kArithmetic;
    PackedMoves moves_;
    core::SharedLog<Other> others_;  ///< what is no move
    std::int64_t strokes_ = 0;
    bool changes_painting_ = false;
};

}  // namespace pastoso::document

// The stroke log of a live session.
#pragma once

#include "document/events.hpp"

namespace pastoso::document {

/// Collects what is applied to a painting, so that the session can be saved and replayed to the same
/// bits.
class Recorder {
  public:
    explicit Recorder(const CanvasSettings& canvas) { recording_.canvas = canvas; }

    /// To be called with Painting::tick() for every action that was applied; ticks do not decrease.
    void add(std::int64_t tick, const Action& action);

    /// The session up to `end_tick`, which is not before the last event.
    Recording recording(std::int64_t end_tick) const;

  private:
    Recording recording_;
};

}  // namespace pastoso::document

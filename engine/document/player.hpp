// Applies a recording to a painting again, tick by tick.
#pragma once

#include "document/events.hpp"
#include "document/painting.hpp"

#include <cstddef>
#include <string>
#include <utility>

namespace pastoso::document {

/// How many steps back from the latest that it has made until then Undo goes at most in a recording, or
/// a little more; 0: it has no Undo. With so many steps kept a replay can follow it.
std::size_t undo_depth(const Recording& recording);

class Player {
  public:
    /// The recording's events are applied to `painting` at the painting's own ticks; both outlive the
    /// player. `name` stands for the recording in sentences.
    Player(Painting& painting, const Recording& recording, std::string name = {})
        : painting_(painting), recording_(recording), name_(std::move(name)) {}

    bool finished() const;

    /// Applies the events of the current tick, then lets the tick pass (not after the recording's end).
    /// Throws InputError "NAME, event N: ..." (without a name "event N: ...") with N counted from 0.
    void play_tick();

    /// The share of the recording's ticks that have passed, 0 to 1.
    double progress() const;

  private:
    void apply_due_events();

    Painting& painting_;
    const Recording& recording_;
    const std::string name_;
    std::size_t next_event_ = 0;
};

}  // namespace pastoso::document

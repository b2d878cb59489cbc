// A run of numbered frames, whatever they show: which of them, one after the other, with progress, until
// Ctrl-C; of a simulation with checkpoints, from which it goes on another time.
#pragma once

#include <functional>
#include <string>

namespace pastoso::cli {

/// Frames are counted from 1. Empty where `last` is less than `first`.
struct FrameRange {
    int first = 1, last = 0;

    int count() const { return last < first ? 0 : last - first + 1; }
    friend bool operator==(const FrameRange&, const FrameRange&) = default;
};

/// How many frames so many seconds are. Throws UsageError that names --seconds where there is none.
int count_frames(double seconds, double fps);

/// "FIRST-LAST" or "FRAME", from 1 to `count`; all of them where there is no text. Throws UsageError
/// that names --range.
FrameRange parse_frame_range(const std::string& text, int count);

/// How the user follows it.
struct SequenceShow {
    std::string label;  ///< "drawing"
    bool quiet = false;
};

/// Calls make(frame) for every frame in order. Throws Interrupted after the frame in which the user
/// stopped it, and whatever make() throws.
void for_frames(const FrameRange& range, const SequenceShow& show, const std::function<void(int)>& make);

/// A simulation as the frames that it comes to.
struct SimulatedFrames {
    int stands_at = 0;  ///< the frame it has come to; 0: none yet
    int last = 0;
    std::function<void(int frame)> advance;  ///< from the frame before to this one
    std::function<void(int frame)> put;      ///< makes what is wanted of the frame it stands at
    /// Keeps the simulation as it stands at the frame, in place of what was kept before. None: nothing
    /// is kept.
    std::function<void(int frame)> keep;
    double keep_every_s = 60.0;  ///< of work
};

/// Puts the frame where the simulation stands and all later ones. It is kept every so often, at the end
/// and when the user stops it, be it while a frame is put: whoever goes on there puts that frame first.
/// Throws as for_frames() does.
void simulate_frames(const SimulatedFrames& simulation, const SequenceShow& show);

}  // namespace pastoso::cli

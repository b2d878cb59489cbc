// A run of numbered frames, whatever they show: which of them, one after the other, with progress, until
// Ctrl-C.
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

/// "FIRST-LAST" or "FRAME", from 1 to `count`; all of them where there is no text. Throws UsageError
/// that names
/// --range.
FrameRange parse_frame_range(const std::string& text, int count);

/// How the user follows it.
struct SequenceShow {
    std::string label;  ///< "drawing"
    bool quiet = false;
};

/// Calls make(frame) for every frame in order. Throws Interrupted after the frame in which the user
/// stopped it, and whatever make() throws.
void for_frames(const FrameRange& range, const SequenceShow& show, const std::function<void(int)>& make);

}  // namespace pastoso::cli

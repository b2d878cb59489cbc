#include "cli/frame_sequence.hpp"

#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "cli/stopwatch.hpp"
#include "cli/usage_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pastoso::cli {

int count_frames(double seconds, double fps) {
    const auto count = static_cast<int>(std::lround(seconds * fps));
    if (count < 1) throw UsageError("--seconds: less than one frame.");
    return count;
}

FrameRange parse_frame_range(const std::string& text, int count) {
    if (text.empty()) return {1, count};
    int first = 0, last = 0, read = 0;
    const bool two = std::sscanf(text.c_str(), "%9d-%9d%n", &first, &last, &read) == 2;
    if (!two && std::sscanf(text.c_str(), "%9d%n", &first, &read) == 1) last = first;
    if (static_cast<std::size_t>(read) != text.size() || first < 1 || last < first || last > count) {
        throw UsageError("--range: \"" + text + "\" is not FIRST-LAST, of frames 1 to " +
                         std::to_string(count) + ".");
    }
    return {first, last};
}

void for_frames(const FrameRange& range, const SequenceShow& show,
                const std::function<void(int)>& make) {
    Progress progress(show.label, Progress::style_for_stderr(show.quiet));
    for (int frame = range.first; frame <= range.last; ++frame) {
        make(frame);
        stop_if_interrupted();
        progress.update(static_cast<double>(frame - range.first + 1) / range.count());
    }
}

void simulate_frames(const SimulatedFrames& simulation, const SequenceShow& show) {
    int reached = simulation.stands_at, kept = reached;
    Stopwatch since_kept;
    const auto keep = [&] {
        if (!simulation.keep || reached == kept) return;
        simulation.keep(reached);
        kept = reached;
        since_kept = {};
    };
    try {
        for_frames({std::max(simulation.stands_at, 1), simulation.last}, show, [&](int frame) {
            if (frame > reached) simulation.advance(frame);
            reached = frame;
            simulation.put(frame);
            if (since_kept.seconds() >= simulation.keep_every_s) keep();
        });
    } catch (const Interrupted&) {
        keep();
        throw;
    }
    keep();
}

}  // namespace pastoso::cli

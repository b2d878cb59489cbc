// A painting that Python paints, with the recording of what it does.
#pragma once

#include "brush/pen_sample.hpp"
#include "core/thread_pool.hpp"
#include "document/painting.hpp"
#include "document/recorder.hpp"
#include "python/turn.hpp"

#include <memory>
#include <string>
#include <vector>

namespace pastoso::python {

struct PaintingWork {
    std::shared_ptr<core::ThreadPool> pool;
    std::unique_ptr<document::Painting> painting;
    document::Recorder recorder;
    std::vector<std::string> notes;  ///< what opening it has told
    Turn turn;

    PaintingWork(std::shared_ptr<core::ThreadPool> threads, std::unique_ptr<document::Painting> made,
                 document::Recorder past)
        : pool(std::move(threads)), painting(std::move(made)), recorder(std::move(past)) {}
};

// To be called within a turn. All throw InputError as the engine's functions do, and leave the painting
// as it was.

/// Applies an action between two ticks and records it.
void perform(const document::Action& action, PaintingWork& work);

/// The action of a JSON object with one entry, as recordings have it beside the tick: {"take_brush":
/// {...}}.
document::Action action_of(const std::string& json_text);

/// Lets so many ticks pass, until `interruption` says so.
void pass_ticks(std::int64_t ticks, Interruption& interruption, PaintingWork& work);

/// The ticks of so many seconds, rounded. Throws InputError for less than 0 s and more than a hundred
/// days.
std::int64_t ticks_of(double seconds);

/// A stroke by samples whose times count from any moment: its first is painted now. Where paint flows
/// meanwhile, ticks pass between the samples as their times say; otherwise none does. `interruption`
/// ends the stroke where it is.
struct Stroke {
    std::vector<brush::PenSample> samples;
    document::Surface surface = document::Surface::Canvas;
    bool flows = true;
};
void paint(Stroke stroke, Interruption& interruption, PaintingWork& work);

}  // namespace pastoso::python

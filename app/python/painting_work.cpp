#include "python/painting_work.hpp"

#include "core/error.hpp"
#include "core/naming.hpp"
#include "document/actions/field_checks.hpp"
#include "files/json_place.hpp"
#include "recordings/action_json.hpp"
#include "recordings/stroke_ticks.hpp"

#include <cmath>

namespace pastoso::python {
namespace {

/// As long as a recording lasts at most.
constexpr double kLongest_s = 100.0 * 24.0 * 3600.0;

void pass_tick(Interruption& interruption, PaintingWork& work) {
    if (work.painting->advance_tick_unless([&] { return interruption.wanted(); }))
        work.recorder.note_tick(work.painting->tick());
}

/// Of times that count from the painting's own beginning, of which `start_s` is now.
void check_and_place(std::vector<brush::PenSample>& samples, double start_s) {
    if (samples.empty()) throw core::InputError("a stroke needs at least one sample.");
    const double first_s = samples.front().time_s;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        core::naming("sample " + std::to_string(i), [&] {
            samples[i].time_s += start_s - first_s;
            document::check_sample(samples[i]);
            if (i > 0) document::check_time_order(samples[i - 1], samples[i]);
        });
    }
}

}  // namespace

void perform(const document::Action& action, PaintingWork& work) {
    work.painting->apply(action);
    work.recorder.add(work.painting->tick(), action);
}

document::Action action_of(const std::string& json_text) {
    const std::string name = "action";
    const files::Json json = files::parse_json(json_text, name);
    recordings::ValueReader values;
    const recordings::FoundAction found = recordings::read_action(files::JsonPlace(json, name), values);
    found.content.guard([&] { document::check_action(found.action); });
    return found.action;
}

void pass_ticks(std::int64_t ticks, Interruption& interruption, PaintingWork& work) {
    // A painting at rest takes no steps in which it could be asked.
    for (std::int64_t i = 0; i < ticks && !interruption.wanted(); ++i)
        pass_tick(interruption, work);
}

std::int64_t ticks_of(double seconds) {
    document::check_between("time", "s", seconds, 0.0, kLongest_s);
    return std::llround(seconds / document::kTick_s);
}

void paint(Stroke stroke, Interruption& interruption, PaintingWork& work) {
    std::vector<brush::PenSample>& samples = stroke.samples;
    const std::int64_t first_tick = work.painting->tick();
    check_and_place(samples, static_cast<double>(first_tick) * document::kTick_s);
    perform(document::PenDown{samples.front(), stroke.surface}, work);
    for (std::size_t i = 1; i < samples.size() && !interruption.wanted(); ++i) {
        const std::int64_t now = work.painting->tick();
        if (stroke.flows)
            pass_ticks(recordings::tick_of_time(samples[i].time_s, now) - now, interruption, work);
        perform(document::PenMove{samples[i]}, work);
    }
    perform(document::PenUp{}, work);
}

}  // namespace pastoso::python

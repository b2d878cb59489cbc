#include "document/recorder.hpp"

#include "core/check.hpp"

namespace pastoso::document {

void Recorder::add(std::int64_t tick, const Action& action) {
    PASTOSO_CHECK_OP(tick, >=, recording_.end_tick);
    recording_.events.push_back({tick, action});
    recording_.end_tick = tick;
}

Recording Recorder::recording(std::int64_t end_tick) const {
    PASTOSO_CHECK_OP(end_tick, >=, recording_.end_tick);
    Recording copy = recording_;
    copy.end_tick = end_tick;
    return copy;
}

}  // namespace pastoso::document

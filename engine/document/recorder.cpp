#include "document/recorder.hpp"

#include "core/check.hpp"

namespace pastoso::document {

Recorder::Recorder(const Recording& past)
    : canvas_(past.canvas), end_tick_(past.end_tick), arithmetic_(past.arithmetic) {
    for (const Event& event : past.events)
        append(event);
}

void Recorder::add(std::int64_t tick, const Action& action) {
    note_tick(tick);
    append({tick, action});
}

void Recorder::append(const Event& event) {
    strokes_ += std::holds_alternative<PenDown>(event.action) ? 1 : 0;
    changes_painting_ |= traits_of(event.action).changes_painting;
    if (const auto* move = std::get_if<PenMove>(&event.action))
        moves_.add({event.tick, move->sample});
    else
        others_.add({moves_.size(), event});
}

void Recorder::note_tick(std::int64_t tick) {
    PASTOSO_CHECK_OP(tick, >=, end_tick_);
    end_tick_ = tick;
}

Recording Recorder::recording() const {
    Recording recording{canvas_, {}, end_tick_, arithmetic_};
    recording.events.reserve(moves_.size() + others_.size());
    PackedMoves::Reader moves(moves_);
    std::size_t read = 0;
    const auto add_moves_until = [&](std::size_t end) {
        for (; read < end; ++read) {
            const TimedSample move = moves.next();
            recording.events.push_back({move.tick, PenMove{move.sample}});
        }
    };
    for (std::size_t i = 0; i < others_.size(); ++i) {
        add_moves_until(others_[i].moves_before);
        recording.events.push_back(others_[i].event);
    }
    add_moves_until(moves_.size());
    return recording;
}

}  // namespace pastoso::document

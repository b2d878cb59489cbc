#include "document/player.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <string>

namespace pastoso::document {

std::size_t undo_depth(const Recording& recording) {
    std::size_t below = 0, most = 0;
    for (const Event& event : recording.events) {
        const UndoRole role = undo_role(event.action);
        if (role == UndoRole::Undo) ++below;
        if ((role == UndoRole::Redo || role == UndoRole::Step) && below > 0) --below;
        most = std::max(most, below);
    }
    return most;
}

bool Player::finished() const {
    return next_event_ == recording_.events.size() && painting_.tick() >= recording_.end_tick;
}

void Player::play_tick() {
    apply_due_events();
    if (!finished()) painting_.advance_tick();
}

double Player::progress() const {
    if (recording_.end_tick <= 0) return finished() ? 1.0 : 0.0;
    return std::min(1.0,
                    static_cast<double>(painting_.tick()) / static_cast<double>(recording_.end_tick));
}

void Player::apply_due_events() {
    const auto& events = recording_.events;
    for (; next_event_ < events.size() && events[next_event_].tick <= painting_.tick(); ++next_event_) {
        try {
            painting_.apply(events[next_event_].action);
        } catch (const core::InputError& error) {
            if (name_.empty()) throw core::InputError("event %1: %2", next_event_, error.message());
            throw core::InputError("%1, event %2: %3", name_, next_event_, error.message());
        }
    }
}

}  // namespace pastoso::document

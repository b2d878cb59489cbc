#include "view/interaction_stack.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::view {

screen::OverlayFrame Overlay::around(const glm::dvec2& place_mm) const {
    screen::OverlayFrame frame = canvas;
    frame.origin_px += canvas.px_from_mm * place_mm;
    return frame;
}

void InteractionStack::handle(const input::PointerEvent& event) {
    using input::Kind;
    if (event.kind == Kind::Cancel) return cancel();
    if (holder_ != nullptr && event.kind == Kind::Move && !event.buttons.testFlag(held_by_))
        release(event);
    if (event.kind == Kind::Press) return press(event);
    if (event.kind == Kind::Release) {
        if (event.button == held_by_) release(event);
        return;
    }
    if (holder_ != nullptr) return holder_->drag(event);
    for (Interaction* interaction : interactions_)
        interaction->hover(event);
}

void InteractionStack::press(const input::PointerEvent& event) {
    if (holder_ != nullptr) return;
    for (Interaction* interaction : interactions_) {
        const Took took = interaction->press(event);
        if (took == Took::Nothing) continue;
        if (took == Took::Press) return;
        holder_ = interaction;
        held_by_ = event.button;
        return;
    }
}

void InteractionStack::release(const input::PointerEvent& event) {
    held_by_ = Qt::NoButton;
    if (Interaction* holder = std::exchange(holder_, nullptr)) holder->release(event);
}

void InteractionStack::cancel() {
    held_by_ = Qt::NoButton;
    if (Interaction* holder = std::exchange(holder_, nullptr)) holder->cancel();
}

bool InteractionStack::key(const QKeyEvent& event) {
    return std::any_of(interactions_.begin(), interactions_.end(),
                       [&](Interaction* one) { return one->key(event); });
}

bool InteractionStack::needs_key(const QKeyEvent& event) const {
    return std::any_of(interactions_.begin(), interactions_.end(),
                       [&](const Interaction* one) { return one->needs_key(event); });
}

void InteractionStack::keys_lost() {
    for (Interaction* interaction : interactions_)
        interaction->keys_lost();
}

/// What is asked first lies on top.
void InteractionStack::draw(const Overlay& overlay) {
    for (auto one = interactions_.rbegin(); one != interactions_.rend(); ++one)
        (*one)->draw(overlay);
}

QCursor InteractionStack::cursor() const {
    for (const Interaction* interaction : interactions_)
        if (const auto cursor = interaction->cursor()) return *cursor;
    return Qt::CrossCursor;
}

bool InteractionStack::is_behind_mode(const Interaction& interaction) const {
    for (const Interaction* one : interactions_) {
        if (one == &interaction) return false;
        if (one->is_mode() || one == holder_) return true;
    }
    return false;
}

}  // namespace pastoso::view

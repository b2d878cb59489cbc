#include "interactions/colour_wand.hpp"

#include "interactions/event_combination.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QKeyEvent>

namespace pastoso::interactions {
namespace {

using view::Took;

/// A hand that only clicks drags less far.
constexpr double kClick_px = 4.0;

constexpr double kPullPerDifference_px = 8.0;

}  // namespace

void ColourWand::take(std::optional<WandReach> reach) {
    reach_ = reach;
    pressed_.reset();
    canvas_.refresh();
}

Took ColourWand::press(const input::PointerEvent& event) {
    if (!reach_ || event.button != Qt::LeftButton) return Took::Nothing;
    pressed_at_ = event.place;
    before_ = difference_;
    pressed_ = {event.pointer.x_mm, event.pointer.y_mm, difference_, reach_ == WandReach::Connected,
                combination(event.modifiers)};
    Q_EMIT pulled(*pressed_);
    return Took::Pointer;
}

void ColourWand::drag(const input::PointerEvent& event) {
    if (!pressed_) return;
    const double way_px = event.place.x() - pressed_at_.x();
    const double pull_px = std::copysign(std::max(std::abs(way_px) - kClick_px, 0.0), way_px);
    difference_ = std::clamp(std::round(before_ + pull_px / kPullPerDifference_px), 1.0,
                             document::kMostDifference);
    if (difference_ == pressed_->difference) return;
    pressed_->difference = difference_;
    Q_EMIT pulled(*pressed_);
}

void ColourWand::release(const input::PointerEvent& event) {
    if (!pressed_) return;
    if (event.kind == input::Kind::Release) drag(event);
    Q_EMIT chosen(*std::exchange(pressed_, std::nullopt));
}

void ColourWand::cancel() {
    if (!pressed_) return;
    pressed_.reset();
    difference_ = before_;
    Q_EMIT cancelled();
}

bool ColourWand::key(const QKeyEvent& event) {
    if (event.type() != QEvent::KeyPress || event.key() != Qt::Key_Escape || !reach_) return false;
    if (pressed_) {
        cancel();
    } else {
        take(std::nullopt);
        Q_EMIT left();
    }
    return true;
}

std::optional<QCursor> ColourWand::cursor() const {
    return reach_ ? std::optional(QCursor(Qt::PointingHandCursor)) : std::nullopt;
}

}  // namespace pastoso::interactions

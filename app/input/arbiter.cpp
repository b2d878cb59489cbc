#include "input/arbiter.hpp"

namespace pastoso::input {
namespace {

/// A pen that is near tells more often than this.
constexpr std::uint64_t kPenNear_ms = 500;

}  // namespace

Arbiter::Verdict Arbiter::judge(const PointerEvent& event) {
    const Holder device = event.is_pen() ? Holder::Pen : Holder::Mouse;
    if (event.is_pen()) pen_seen_ms_ = event.pointer.time_ms;
    const bool takes_over = event.is_pen() && holder_ == Holder::Fingers;
    if (takes_over) holder_.reset();
    if (holder_ && *holder_ != device) return Verdict::Ignore;
    if (event.kind == Kind::Press) holder_ = device;
    if (event.buttons == Qt::NoButton) holder_.reset();
    return takes_over ? Verdict::TakeOver : Verdict::Hear;
}

bool Arbiter::hears_fingers(std::uint64_t began_ms) {
    if (holder_ && *holder_ != Holder::Fingers) return false;
    return !pen_seen_ms_ || began_ms > *pen_seen_ms_ + kPenNear_ms;
}

void Arbiter::fingers_hold(bool hold) {
    if (hold)
        holder_ = Holder::Fingers;
    else if (holder_ == Holder::Fingers)
        holder_.reset();
}

}  // namespace pastoso::input

#include "tools/easel.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pastoso::tools {

using namespace document;

Easel::Easel(Hand hand, Post post, std::function<void()> note_hand)
    : hand_(std::move(hand)), post_(std::move(post)), note_hand_(std::move(note_hand)) {}

void Easel::set_up() {
    post_(UseMedium{hand_.medium});
    post_(hand_.tilt);
    post_(SetDrying{hand_.air});
    take_brush(hand_.brush, hand_.brush_width_mm);
}

void Easel::take_brush(const std::string& preset, double width_mm) {
    end_stroke();
    hand_.brush = preset;
    hand_.brush_width_mm = std::clamp(width_mm, kSmallestBrush_mm, kLargestBrush_mm);
    post_(TakeBrush{preset, hand_.brush_width_mm, ++brushes_taken_});
    reload();
}

void Easel::set_brush_width(double width_mm) {
    const double width = std::clamp(width_mm, kSmallestBrush_mm, kLargestBrush_mm);
    if (width != hand_.brush_width_mm) take_brush(hand_.brush, width);
}

void Easel::choose_paint(const PaintRecipe& paint) {
    hand_.paint = paint;
    reload();
}

void Easel::reload() {
    clean();
    LoadPaint dip;
    dip.paint = hand_.paint;
    post_(dip);
}

void Easel::clean() {
    end_stroke();
    post_(CleanBrush{});
}

void Easel::use_medium(const std::string& name) {
    clean();
    hand_.medium = name;
    post_(UseMedium{name});
    reload();
}

void Easel::tilt(double tilt_deg, double direction_deg) {
    hand_.tilt = {tilt_deg, direction_deg};
    post_(hand_.tilt);
}

void Easel::set_drying_speed(double speed) {
    hand_.air.speed = speed;
    post_(SetDrying{hand_.air});
}

void Easel::dry_now() {
    end_stroke();
    post_(DryNow{});
}

void Easel::set_reload_each_stroke(bool reload) {
    hand_.reload_each_stroke = reload;
}

void Easel::set_turn_with_stroke(bool turn) {
    hand_.turn_with_stroke = turn;
}

void Easel::undo() {
    end_stroke();
    post_(Undo{});
}

void Easel::redo() {
    end_stroke();
    post_(Redo{});
}

void Easel::press(const Pointer& pointer) {
    end_stroke();
    if (hand_.reload_each_stroke) reload();
    painting_ = true;
    follow(pointer);
    post_(PenDown{sample(pointer)});
}

void Easel::move(const Pointer& pointer) {
    follow(pointer);
    if (painting_) post_(PenMove{sample(pointer)});
}

void Easel::release() {
    end_stroke();
}

void Easel::end_stroke() {
    if (!std::exchange(painting_, false)) return;
    post_(PenUp{});
}

void Easel::follow(const Pointer& pointer) {
    if (note_hand_) note_hand_();
    heading_.moved_to(pointer.x_mm, pointer.y_mm);
    rotation_deg_ =
        pointer.rotation_deg.value_or(hand_.turn_with_stroke ? heading_.rotation_deg() : 0.0);
}

/// The sample in the engine's terms. Time starts at the first touch and never runs backwards, even where
/// a driver's clock does.
brush::PenSample Easel::sample(const Pointer& pointer) {
    if (!std::exchange(has_clock_zero_, true)) clock_zero_ms_ = pointer.time_ms;
    const std::uint64_t since_ms = pointer.time_ms - std::min(clock_zero_ms_, pointer.time_ms);
    previous_time_s_ = std::max(previous_time_s_, 1e-3 * static_cast<double>(since_ms));
    return {.time_s = previous_time_s_,
            .x_mm = pointer.x_mm,
            .y_mm = pointer.y_mm,
            .pressure = std::clamp(pointer.pressure, 0.0, 1.0),
            .tilt_x_deg = std::clamp(pointer.tilt_x_deg, -90.0, 90.0),
            .tilt_y_deg = std::clamp(pointer.tilt_y_deg, -90.0, 90.0),
            .rotation_deg = rotation_deg_};
}

}  // namespace pastoso::tools

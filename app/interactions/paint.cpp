#include "interactions/paint.hpp"

#include "tools/touch_doubt.hpp"

namespace pastoso::interactions {
namespace {

using view::Took;

/// Longer than the pause between two events of a moving hand.
constexpr int kWait_ms = 25;

/// With which a pen in the air is shown, before it presses.
constexpr double kExpectedPressure = 0.5;

bool is_beside(const tools::Pointer& pointer, const glm::dvec2& size_mm) {
    const bool across = pointer.x_mm >= 0.0 && pointer.x_mm < size_mm.x;
    return !across || pointer.y_mm < 0.0 || pointer.y_mm >= size_mm.y;
}

}  // namespace

Paint::Paint(view::CanvasView& canvas, tools::Easel& easel, document::Surface surface)
    : canvas_(canvas), easel_(easel), surface_(surface) {
    waiting_.setInterval(kWait_ms);
    connect(&waiting_, &QTimer::timeout, this, [this] {
        if (mark_.rest()) canvas_.refresh();
        easel_.wait(0.001 * kWait_ms, surface_);
        if (!easel_.painting()) waiting_.stop();
    });
}

void Paint::set_tool(const brush::Preset& tool) {
    outline_.set_tool(tool);
    canvas_.refresh();
}

void Paint::note_posted(const document::Action& action, std::uint64_t number) {
    mark_.note(action, number, easel_.hand(), outline_);
}

/// Control squeezes paint onto the well instead of painting there.
Took Paint::press(const input::PointerEvent& event) {
    const bool may = event.device != input::Device::Finger || canvas_.pen().fingers_paint;
    if (event.button != Qt::LeftButton || !may) return Took::Nothing;
    waiting_.start();
    tools::Pointer pointer = event.pointer;
    pointer.beside = is_beside(pointer, canvas_.canvas_size_mm()) || may_touch_nothing(pointer);
    pressure_ = pointer.pressure;
    if (surface_ == document::Surface::Well && event.modifiers.testFlag(Qt::ControlModifier)) {
        easel_.squeeze(pointer.x_mm, pointer.y_mm);
        return Took::Pointer;
    }
    easel_.press(pointer, event.modifiers.testFlag(Qt::ShiftModifier));
    if (surface_ == document::Surface::Canvas) Q_EMIT stroke_begun({pointer.x_mm, pointer.y_mm});
    return Took::Pointer;
}

bool Paint::may_touch_nothing(const tools::Pointer& pointer) const {
    const document::Snapshot* shown = canvas_.shown();
    return surface_ == document::Surface::Canvas && shown != nullptr &&
           tools::may_touch_nothing(*shown, pointer.x_mm, pointer.y_mm);
}

/// In the air, too.
void Paint::drag(const input::PointerEvent& event) {
    if (easel_.painting()) waiting_.start();
    pressure_ = event.pointer.pressure;
    easel_.move(event.pointer);
}

void Paint::release(const input::PointerEvent& event) {
    tools::Pointer last = event.pointer;
    if (last.pressure == 0.0) last.pressure = pressure_;  // a pen that has lifted presses no more
    if (event.kind == input::Kind::Release && easel_.painting()) easel_.move(last);
    easel_.release();
}

void Paint::cancel() {
    easel_.release();
}

/// What the brush touches as it is held, and how its handle leans.
void Paint::draw(const view::Overlay& overlay) {
    if (marks() && mark_.draw(*canvas_.shown(), overlay, outline_)) Q_EMIT marked();
    const auto place_mm = canvas_.pointer_mm();
    if (!place_mm || canvas_.interactions().is_behind_mode(*this)) return;
    draw_line(overlay, *place_mm);
    brush::PenSample held = easel_.held();
    if (held.pressure == 0.0 && !easel_.painting()) held.pressure = kExpectedPressure;
    const screen::OverlayFrame frame = overlay.around(*place_mm);
    overlay.painter.draw_loop(outline_.around_mm(held), frame, 1.0F);
    const glm::dvec2 handle = handle_px(held.tilt_x_deg, held.tilt_y_deg);
    if (handle == glm::dvec2(0.0)) return;
    overlay.painter.draw_segments({glm::vec2(0.0F), glm::vec2(overlay.px_mm * handle)}, frame, 0.8F);
}

/// Looks in which paint has another colour have no mark.
bool Paint::marks() const {
    const screen::Look look = canvas_.look();
    return canvas_.pen().wet_mark && (look == screen::Look::Lit || look == screen::Look::Flat);
}

/// The straight line that is being drawn.
void Paint::draw_line(const view::Overlay& overlay, const glm::dvec2& end_mm) const {
    const std::optional<tools::Pointer> start = easel_.line_start();
    if (!start || surface_ != document::Surface::Canvas) return;
    overlay.painter.draw_segments({glm::vec2(start->x_mm, start->y_mm), glm::vec2(end_mm)},
                                  overlay.canvas, 1.0F);
}

}  // namespace pastoso::interactions

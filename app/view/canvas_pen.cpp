// The part of CanvasView that reads pens, and a mouse as one: pressure, tilt, buttons, ends; and shows
// how the brush is held.

#include "tools/pen_device_of.hpp"
#include "view/canvas_view.hpp"
#include "view/turned_pen.hpp"

#include <utility>

#include <QApplication>
#include <QTabletEvent>

namespace pastoso::view {
namespace {

/// With which a pen in the air is shown, before it presses.
constexpr double kExpectedPressure = 0.5;

}  // namespace

/// Of a mouse or a finger.
tools::Pointer CanvasView::pointer_at(const QPointF& position, std::uint64_t time_ms) {
    const glm::dvec2 mm = canvas_mm(position);
    mouse_pressure_.moved_to({position.x(), position.y()}, time_ms);
    tools::Pointer pointer;
    pointer.surface = surface_;
    pointer.x_mm = mm.x;
    pointer.y_mm = mm.y;
    pointer.pressure = mouse_pressure_.pressure(pen_.mouse);
    pointer.time_ms = time_ms;
    return against_canvas(view_, pointer);
}

/// The one place where told pressure becomes the pressure that the painter means.
tools::Pointer CanvasView::pen_pointer(const QTabletEvent& event) const {
    const glm::dvec2 mm = canvas_mm(event.position());
    const QPointingDevice* device = event.pointingDevice();
    tools::Pointer pointer;
    pointer.surface = surface_;
    pointer.x_mm = mm.x;
    pointer.y_mm = mm.y;
    pointer.pressure = event.pressure();
    pointer.tilt_x_deg = event.xTilt();
    pointer.tilt_y_deg = event.yTilt();
    pointer.time_ms = event.timestamp();
    if (device != nullptr) {
        pointer.pressure = tools::mapped_pressure(pen_, tools::pen_device_of(*device), pointer.pressure);
        pointer.tells_tilt = device->capabilities().testFlag(QInputDevice::Capability::XTilt);
        if (device->capabilities().testFlag(QInputDevice::Capability::Rotation))
            pointer.rotation_deg = event.rotation();
    }
    return against_canvas(view_, pointer);
}

void CanvasView::tabletEvent(QTabletEvent* event) {
    event->accept();
    if (closes_popup(*event)) return;
    Q_EMIT pen_used(event->pointerType() == QPointingDevice::PointerType::Eraser);
    if (view_drag_) drag_view(event->position(), event->modifiers());
    follow_pointer(event->position());
    switch (event->type()) {
        case QEvent::TabletPress:
            press_pen(*event);
            break;
        case QEvent::TabletRelease:
            view_drag_.reset();
            if (area_drag_.active()) drag_area(event->position(), event->modifiers());
            if (frame_drag_) drag_frame(event->position(), event->modifiers());
            if (event->button() == Qt::LeftButton) release_pointer();
            set_cursor();
            break;
        default:
            if (!event->buttons().testFlag(Qt::LeftButton)) release_pointer();
            if (!view_drag_ && !drag_guides(event->position(), event->modifiers()))
                easel_->move(pen_pointer(*event));
    }
}

/// What is open over the window goes away at a press beside it, as it does at a click: pens are told to
/// what lies below.
bool CanvasView::closes_popup(const QTabletEvent& event) {
    QWidget* popup = QApplication::activePopupWidget();
    if (event.type() == QEvent::TabletPress && popup != nullptr) {
        closing_popup_ = true;
        popup->close();
    }
    if (closing_popup_ && event.buttons() == Qt::NoButton) return std::exchange(closing_popup_, false);
    return closing_popup_;
}

/// Most drivers tell the lower button as the middle one and the upper as the right one.
void CanvasView::press_pen(const QTabletEvent& event) {
    if (view_drag_ || easel_->painting()) return;
    if (event.button() == Qt::MiddleButton) return press_pen_button(pen_.lower_button, event);
    if (event.button() == Qt::RightButton) return press_pen_button(pen_.upper_button, event);
    if (event.button() != Qt::LeftButton) return;
    if (space_held_)
        begin_view_drag(event.position(), event.modifiers());
    else if (!press_guides(event.position(), event.modifiers()))
        touch_down(pen_pointer(event), event.modifiers());
}

void CanvasView::press_pen_button(tools::PenButtonDoes what, const QTabletEvent& event) {
    const glm::dvec2 mm = canvas_mm(event.position());
    switch (what) {
        case tools::PenButtonDoes::Nothing:
            return;
        case tools::PenButtonDoes::PickPaint:
            return void(Q_EMIT picked({mm.x, mm.y}, tools::Pick::Paint));
        case tools::PenButtonDoes::PickColour:
            return void(Q_EMIT picked({mm.x, mm.y}, tools::Pick::Seen));
        case tools::PenButtonDoes::MoveCanvas:
            return begin_view_drag(event.position(), event.modifiers());
        case tools::PenButtonDoes::PopupPalette:
            if (!frame_) Q_EMIT palette_wanted(event.globalPosition().toPoint());
    }
}

/// What the brush touches as it is held, and how its handle leans.
void CanvasView::draw_tip() {
    const bool paints = !view_drag_ && !space_held_ && !picks_next_ && !area_form_ && !frame_;
    if (tool_hidden_ || !pointer_ || !paints || guide_drag_.active() || light_drag_) return;
    brush::PenSample held = easel_->held();
    if (held.pressure == 0.0 && !easel_->painting()) held.pressure = kExpectedPressure;
    const OverlayFrame frame = overlay_frame(device_px(*pointer_));
    overlay_.draw_loop(outline_.around_mm(held), frame, 1.0F);
    const glm::dvec2 handle = handle_px(held.tilt_x_deg, held.tilt_y_deg);
    if (handle == glm::dvec2(0.0)) return;
    const double mm_per_layout_px = devicePixelRatioF() * mm_per_px();
    overlay_.draw_segments({glm::vec2(0.0F), glm::vec2(mm_per_layout_px * handle)}, frame, 0.8F);
}

}  // namespace pastoso::view

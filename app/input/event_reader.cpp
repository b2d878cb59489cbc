#include "input/event_reader.hpp"

#include "tools/pen_device_of.hpp"

#include <QMouseEvent>
#include <QTabletEvent>

namespace pastoso::input {
namespace {

Kind kind_of(QEvent::Type type) {
    switch (type) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick:
        case QEvent::TabletPress:
            return Kind::Press;
        case QEvent::MouseButtonRelease:
        case QEvent::TabletRelease:
            return Kind::Release;
        default:
            return Kind::Move;
    }
}

/// What mouse and pen are told by alike.
PointerEvent told(const QSinglePointEvent& event, Device device) {
    PointerEvent told;
    told.kind = kind_of(event.type());
    told.device = device;
    told.place = event.position();
    told.desktop = event.globalPosition().toPoint();
    told.button = event.button();
    told.buttons = event.buttons();
    told.modifiers = event.modifiers();
    return told;
}

}  // namespace

/// A mouse's or a finger's.
tools::Pointer EventReader::pressing_at(const QPointF& place, std::uint64_t time_ms) {
    mouse_pressure_.moved_to({place.x(), place.y()}, time_ms);
    tools::Pointer pointer;
    pointer.pressure = mouse_pressure_.pressure(pen_.mouse);
    pointer.time_ms = time_ms;
    return pointer;
}

PointerEvent EventReader::read(const QMouseEvent& event) {
    PointerEvent read = told(event, Device::Mouse);
    read.pointer = pressing_at(read.place, event.timestamp());
    return read;
}

PointerEvent EventReader::read(const QTabletEvent& event) {
    const bool eraser = event.pointerType() == QPointingDevice::PointerType::Eraser;
    PointerEvent read = told(event, eraser ? Device::Eraser : Device::Pen);
    read.pointer.pressure = event.pressure();
    read.pointer.tilt_x_deg = event.xTilt();
    read.pointer.tilt_y_deg = event.yTilt();
    read.pointer.time_ms = event.timestamp();
    if (const QPointingDevice* device = event.pointingDevice()) {
        if (device->type() == QInputDevice::DeviceType::Airbrush)
            read.wheel = read.pointer.wheel = event.tangentialPressure();
        read.pointer.pressure =
            tools::mapped_pressure(pen_, tools::pen_device_of(*device), read.pointer.pressure);
    }
    const PenAbilities::Tells tells = abilities_.note(event);
    read.pointer.tells_tilt = tells.tilt;
    if (tells.rotation) read.pointer.rotation_deg = event.rotation();
    return read;
}

PointerEvent EventReader::finger(Kind kind, const Finger& finger, std::uint64_t time_ms,
                                 Qt::KeyboardModifiers modifiers) {
    if (kind == Kind::Press) mouse_pressure_ = {};  // it comes from nowhere
    PointerEvent told;
    told.kind = kind;
    told.device = Device::Finger;
    told.contact = finger.id;
    told.place = finger.place;
    told.button = kind == Kind::Move ? Qt::NoButton : Qt::LeftButton;
    if (kind == Kind::Press || kind == Kind::Move) told.buttons = Qt::LeftButton;
    told.modifiers = modifiers;
    told.pointer = pressing_at(finger.place, time_ms);
    return told;
}

}  // namespace pastoso::input

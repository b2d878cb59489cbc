// What Qt tells of a pen, in the terms of the settings. The one header here that needs Qt: views and
// panels both read pens.
#pragma once

#include "tools/pen_settings.hpp"

#include <QPointingDevice>

namespace pastoso::tools {

inline PenDevice pen_device_of(const QPointingDevice& device) {
    const PenEnd end = device.pointerType() == QPointingDevice::PointerType::Eraser ? PenEnd::Eraser
                       : device.type() == QInputDevice::DeviceType::Puck            ? PenEnd::Puck
                                                                                    : PenEnd::Tip;
    return pen_device(device.name().toStdString(), end);
}

/// What the painter wants that button to do. Most drivers tell the lower one as the middle button, the
/// upper one as the right one and a third as the first beyond.
inline PenAction action_of(const PenSettings& settings, Qt::MouseButton button) {
    return button == Qt::MiddleButton   ? settings.action(PenButton::Lower)
           : button == Qt::RightButton  ? settings.action(PenButton::Upper)
           : button == Qt::ExtraButton1 ? settings.action(PenButton::Third)
                                        : PenAction{};
}

}  // namespace pastoso::tools

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

}  // namespace pastoso::tools

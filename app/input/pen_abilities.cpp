#include "input/pen_abilities.hpp"

#include <QPointingDevice>
#include <QTabletEvent>

namespace pastoso::input {

/// An axis that a pen does not have stays at 0.
PenAbilities::Tells PenAbilities::note(const QTabletEvent& event) {
    using Capability = QInputDevice::Capability;
    const QPointingDevice* device = event.pointingDevice();
    const QInputDevice::Capabilities announced =
        device == nullptr ? QInputDevice::Capabilities() : device->capabilities();
    Tells& told = told_[device];
    told.tilt |= announced.testFlag(Capability::XTilt) || event.xTilt() != 0 || event.yTilt() != 0;
    told.rotation |= announced.testFlag(Capability::Rotation) || event.rotation() != 0.0;
    return told;
}

}  // namespace pastoso::input

// What pens can tell besides place and pressure.
#pragma once

#include <map>

class QPointingDevice;
class QTabletEvent;

namespace pastoso::input {

/// What a device announces, and what it has ever told: Qt makes up the devices of pens under Wayland,
/// and those announce neither tilt nor rotation though their events bring both.
class PenAbilities {
  public:
    struct Tells {
        bool tilt = false;
        bool rotation = false;
    };

    /// Of the pen that the event is of, with what the event itself tells.
    Tells note(const QTabletEvent& event);

  private:
    std::map<const QPointingDevice*, Tells> told_;
};

}  // namespace pastoso::input

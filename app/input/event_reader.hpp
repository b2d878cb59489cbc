// Makes one kind of event of what Qt tells of mouse, pens and fingers.
#pragma once

#include "input/finger.hpp"
#include "input/pen_abilities.hpp"
#include "input/pointer_event.hpp"
#include "tools/mouse_pressure.hpp"
#include "tools/pen_settings.hpp"

class QMouseEvent;
class QTabletEvent;

namespace pastoso::input {

/// The one place where told pressure becomes the pressure that the painter means. Tilt and rotation are
/// told against the screen, and places of the canvas are not known yet.
class EventReader {
  public:
    void set_pen(const tools::PenSettings& pen) { pen_ = pen; }
    const tools::PenSettings& pen() const { return pen_; }

    PointerEvent read(const QMouseEvent& event);
    PointerEvent read(const QTabletEvent& event);

    /// One finger, which does the work of a mouse's left button.
    PointerEvent finger(Kind kind, const Finger& finger, std::uint64_t time_ms,
                        Qt::KeyboardModifiers modifiers);

  private:
    tools::Pointer pressing_at(const QPointF& place, std::uint64_t time_ms);

    tools::PenSettings pen_;
    PenAbilities abilities_;
    tools::MousePressure mouse_pressure_;
};

}  // namespace pastoso::input

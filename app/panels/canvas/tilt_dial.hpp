// The spirit level of the easel: where down points on the canvas, and how steeply.
#pragma once

#include "panels/canvas/direction_dial.hpp"

namespace pastoso::panels {

/// The bubble swims to the upper side, as in a real level; the arrow shows where paint will run. The
/// dial's angle is the canvas's tilt, its azimuth the direction of down.
class TiltDial : public DirectionDial {
    Q_OBJECT
  public:
    explicit TiltDial(QWidget* parent = nullptr);

  protected:
    void paint_dial(QPainter& painter, const QPointF& centre, double radius,
                    const QPointF& point) override;
};

}  // namespace pastoso::panels

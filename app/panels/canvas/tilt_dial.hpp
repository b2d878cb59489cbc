// How the canvas stands: where down points on it, and how steeply.
#pragma once

#include "panels/canvas/direction_dial.hpp"

namespace pastoso::panels {

/// The knob lies where a drop of paint would run to; the middle is flat, the rim upright. The dial's
/// angle is the canvas's tilt, its azimuth the direction of down.
class TiltDial : public DirectionDial {
    Q_OBJECT
  public:
    explicit TiltDial(QWidget* parent = nullptr);

  protected:
    void paint_dial(QPainter& painter, const QPointF& centre, double radius,
                    const QPointF& point) override;
    QString value_words() const override;
};

}  // namespace pastoso::panels

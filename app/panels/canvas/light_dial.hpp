// The lamp over the canvas: where it stands and how high.
#pragma once

#include "panels/canvas/direction_dial.hpp"

namespace pastoso::panels {

/// The dial's centre is the zenith, its rim a raking light. elevation_deg() and light_azimuth_deg() are
/// those of shade::Lighting (azimuth 0 right, 90 top).
class LightDial : public DirectionDial {
    Q_OBJECT
  public:
    explicit LightDial(QWidget* parent = nullptr);

    double elevation_deg() const { return 90.0 - angle_deg(); }
    double light_azimuth_deg() const { return 360.0 - azimuth_deg(); }
    void set_light(double elevation_deg, double azimuth_deg) {
        set(90.0 - elevation_deg, 360.0 - azimuth_deg);
    }

  protected:
    void paint_dial(QPainter& painter, const QPointF& centre, double radius,
                    const QPointF& point) override;
    QString value_words() const override;
    void reset() override;
};

}  // namespace pastoso::panels

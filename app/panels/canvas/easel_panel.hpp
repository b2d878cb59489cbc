// How the canvas stands, where the lamp is and how fast paint dries.
#pragma once

#include "shade/render.hpp"

#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace pastoso::panels {

class DirectionDial;
class LightDial;
class TiltDial;

class EaselPanel : public QWidget {
    Q_OBJECT
  public:
    explicit EaselPanel(QWidget* parent = nullptr);

    /// Shows a tilt, without a signal.
    void show_tilt(double tilt_deg, double direction_deg);

    /// Shows where the light comes from, without a signal.
    void show_light(const shade::Lighting& lighting);

    /// Shows how fast paint dries, without a signal.
    void show_drying(double speed);

  Q_SIGNALS:
    void tilted(double tilt_deg, double direction_deg);
    void light_moved(double elevation_deg, double azimuth_deg);
    void drying_changed(double speed);

  private:
    /// A direction in degrees, to be read and typed.
    struct DirectionBoxes {
        QDoubleSpinBox *angle, *azimuth;
    };

    QWidget* column(const QString& heading, DirectionDial* dial, const DirectionBoxes& boxes);
    void set_tilt(double tilt_deg, double direction_deg);
    void set_light(double elevation_deg, double azimuth_deg);
    void tell_tilt();
    void tell_light();
    QWidget* drying_row();
    void write_readings();

    TiltDial* tilt_ = nullptr;
    LightDial* light_ = nullptr;
    DirectionBoxes tilt_boxes_, light_boxes_;
    QSlider* drying_ = nullptr;
    QLabel* drying_reading_ = nullptr;
};

}  // namespace pastoso::panels

// A sheet to try pens on: scribbles with pen or mouse, and tells what it is told.
#pragma once

#include "input/pen_abilities.hpp"
#include "tools/event_rate.hpp"
#include "tools/mouse_pressure.hpp"
#include "tools/pen_settings.hpp"

#include <optional>

#include <QImage>
#include <QWidget>

namespace pastoso::panels {

/// What one event told, and what the settings make of it.
struct PenReading {
    std::optional<tools::PenDevice> device;  ///< none: the mouse
    double told = 0.0;                       ///< pressure
    double meant = 0.0;
    double tilt_x_deg = 0.0, tilt_y_deg = 0.0;
    std::optional<double> rotation_deg;
    Qt::MouseButtons buttons;
    double rate_Hz = 0.0;
};

class PenPad : public QWidget {
    Q_OBJECT
  public:
    explicit PenPad(QWidget* parent = nullptr);

    void use(const tools::PenSettings& settings) { settings_ = settings; }
    void wipe();

    const QImage& sheet() const { return sheet_; }

    QSize sizeHint() const override { return {420, 190}; }
    QSize minimumSizeHint() const override { return {240, 120}; }

  Q_SIGNALS:
    void read(const PenReading& reading);

    /// The device has touched the sheet; none: the mouse.
    void touched(const std::optional<tools::PenDevice>& device);

  protected:
    void tabletEvent(QTabletEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    void read_mouse(const QMouseEvent& event);
    void scribble(const QPointF& to, double pressure);

    tools::PenSettings settings_;
    tools::MousePressure mouse_;
    tools::EventRate rate_;
    input::PenAbilities abilities_;
    QImage sheet_;  ///< transparent where it is bare
    bool bare_ = true;
    std::optional<QPointF> from_;
};

}  // namespace pastoso::panels

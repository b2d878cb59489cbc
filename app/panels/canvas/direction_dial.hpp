// A round control for a direction in space: a point in a disc, dragged or set with the keys and the
// wheel.
#pragma once

#include <QPointF>
#include <QWidget>

namespace pastoso::panels {

/// The point's direction from the centre is an azimuth (0 to the right, 90 down the screen), its
/// distance an angle from 0 at the centre to `full_angle_deg` at the rim.
class DirectionDial : public QWidget {
    Q_OBJECT
  public:
    explicit DirectionDial(double full_angle_deg, QWidget* parent = nullptr);

    double angle_deg() const { return angle_deg_; }
    double azimuth_deg() const { return azimuth_deg_; }
    double full_angle_deg() const { return full_angle_deg_; }

    /// Moves the point without a signal.
    void set(double angle_deg, double azimuth_deg);

    QSize sizeHint() const override { return {104, 104}; }
    QSize minimumSizeHint() const override { return {88, 58}; }

  Q_SIGNALS:
    void dragged(double angle_deg, double azimuth_deg);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

    /// Draws what is particular to a dial; `point` is where the knob goes.
    virtual void paint_dial(QPainter& painter, const QPointF& centre, double radius,
                            const QPointF& point) = 0;

    /// How it stands, for those who do not see it.
    virtual QString value_words() const = 0;

    /// The direction that a double click returns to.
    virtual void reset() { drag_to(0.0, azimuth_deg_); }

    void drag_to(double angle_deg, double azimuth_deg);

  private:
    void drag_to_point(const QPointF& position);
    void step(const QPointF& way_deg);
    QPointF centre() const;
    double radius() const;

    double full_angle_deg_;
    double angle_deg_ = 0.0;
    double azimuth_deg_ = 90.0;
};

}  // namespace pastoso::panels

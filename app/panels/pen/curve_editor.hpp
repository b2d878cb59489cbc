// A piecewise linear curve that is edited point by point, by mouse and by keys.
#pragma once

#include "tools/curve_edit.hpp"

#include <QPointF>
#include <QWidget>

namespace pastoso::panels {

/// Press on a point to drag it, beside the curve's points to add one; Delete or a right click takes one
/// away. Keys: Page Up and Page Down choose a point, arrows move it (Ctrl: finely), Insert adds one
/// behind it.
class CurveEditor : public QWidget {
    Q_OBJECT
  public:
    explicit CurveEditor(QWidget* parent = nullptr);

    /// Shows a curve without a signal. A point that was chosen stays chosen where there still is one.
    void show_curve(const brush::DynamicsCurve& curve);

    /// From now on the curve rises from side to side of the frame and never falls.
    void keep_rising() { rises_ = true; }

    const tools::CurvePoints& points() const { return curve_.points; }
    const tools::CurveFrame& frame() const { return frame_; }
    int chosen_point() const { return chosen_; }  ///< -1: none

    /// Where a point of the curve lies in the widget, and back.
    QPointF position_of(const brush::CurvePoint& point) const;
    brush::CurvePoint point_at(const QPointF& position) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

  Q_SIGNALS:
    void edited(const tools::CurvePoints& points);

    /// The mouse is over this input, or a point there was chosen.
    void read_at(double input);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;

  private:
    QRectF plot() const;
    int point_near(const QPointF& position) const;
    void choose(int index);
    void say();
    void move_chosen(const brush::CurvePoint& place);
    int add(const brush::CurvePoint& place);
    void step_chosen(int key, bool fine);
    void add_behind_chosen();
    void remove_chosen();

    brush::DynamicsCurve curve_;
    tools::CurveFrame frame_;
    int chosen_ = -1;
    bool dragging_ = false;
    bool rises_ = false;
};

}  // namespace pastoso::panels

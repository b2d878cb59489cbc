// A small picture of the whole canvas, on which what the window shows of it is framed: dragged and
// clicked to go there.
#pragma once

#include <QImage>
#include <QPixmap>
#include <QPolygonF>
#include <QWidget>

namespace pastoso::panels {

class NavigatorMap : public QWidget {
    Q_OBJECT
  public:
    explicit NavigatorMap(QWidget* parent = nullptr);

    /// Of the whole canvas, as it is saved.
    void show_picture(const QImage& picture);

    /// The corners of what the window shows, its upper left one first, as shares of the canvas from its
    /// upper left corner: a turned view is a turned frame.
    void show_frame(const QSizeF& canvas, const QPolygonF& corners);

    /// Where a share of the canvas lies on the widget, and back.
    QPointF widget_position(const QPointF& share) const;
    QPointF share_at(const QPointF& position) const;
    const QPolygonF& frame() const { return frame_; }

    QSize sizeHint() const override { return {260, 190}; }
    QSize minimumSizeHint() const override { return {160, 110}; }

  Q_SIGNALS:
    /// The window is to show that place, a share of the canvas, in its middle.
    void centre_wanted(const QPointF& share);

    /// The wheel was turned by so many notches, away from the painter.
    void zoomed(double notches);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    QRectF canvas_place() const;
    QPointF centre() const;
    void fit_picture();
    void step(const QPointF& way);

    QSizeF canvas_{1.0, 1.0};  ///< its proportions
    QPolygonF frame_;
    QImage picture_;
    QPixmap shown_;  ///< the picture at the widget's size
    QPointF pressed_, grip_;
    bool held_ = false, dragged_ = false;
};

}  // namespace pastoso::panels

// A picture to look at while painting: zoomed and moved by wheel and drag, a click picks a colour of it.
#pragma once

#include <QImage>
#include <QPointF>
#include <QWidget>

namespace pastoso::panels {

class PictureBoard : public QWidget {
    Q_OBJECT
  public:
    explicit PictureBoard(QWidget* parent = nullptr);

    /// Shows it whole. A null picture is none.
    void show_picture(const QImage& picture);
    void fit();
    void zoom_about(const QPointF& position, double factor);

    /// The picture's pixel under a point of the widget, as it is; not valid beside it.
    QColor colour_at(const QPointF& position) const;

    QSize sizeHint() const override { return {260, 200}; }
    QSize minimumSizeHint() const override { return {160, 110}; }

  Q_SIGNALS:
    void colour_picked(const QColor& colour);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    double fitting_zoom() const;
    QPointF widget_position(const QPointF& pixel) const { return zoom_ * pixel + corner_; }
    QPointF pixel_at(const QPointF& position) const { return (position - corner_) / zoom_; }
    void move_by(const QPointF& distance);

    QImage picture_;
    QImage shown_;       ///< the same in the colours of the screen
    double zoom_ = 1.0;  ///< widget units of a pixel
    QPointF corner_;     ///< of the picture, on the widget
    bool fitted_ = true;
    QPointF pressed_, dragged_to_;
    bool dragging_ = false;
};

}  // namespace pastoso::panels

// A slider that shows along its length which colours it leads to.
#pragma once

#include <QSlider>
#include <QVector>

namespace pastoso::panels {

class ChannelSlider : public QSlider {
    Q_OBJECT
  public:
    explicit ChannelSlider(QWidget* parent = nullptr);

    /// Colours at even distances from the slider's least to its most value; two or more.
    void show_ramp(const QVector<QColor>& ramp);

    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

  private:
    void drag_to(double x);

    QVector<QColor> ramp_;
};

}  // namespace pastoso::panels

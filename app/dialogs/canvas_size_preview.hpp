// A canvas as it is, or turned, within what it will be, small.
#pragma once

#include "tools/canvas_resizing.hpp"

#include <QImage>
#include <QRectF>
#include <QSizeF>
#include <QWidget>

namespace pastoso::dialogs {

class CanvasSizePreview : public QWidget {
  public:
    /// `picture` is the painting of so many millimetres.
    CanvasSizePreview(const QImage& picture, const QSizeF& size_mm, QWidget* parent = nullptr);

    void show_margins(const tools::Margins& margins);
    /// A canvas of that size, in the middle of which the picture is turned, clockwise.
    void show_rotated(const QSizeF& size_mm, double turn_deg);

    QSize sizeHint() const override { return {230, 190}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QImage picture_;
    QRectF before_mm_, after_mm_;
    double turn_deg_ = 0.0;  ///< of the picture, about its middle
};

}  // namespace pastoso::dialogs

// A canvas as it is within what it will be, small.
#pragma once

#include "tools/canvas_resizing.hpp"

#include <QImage>
#include <QSizeF>
#include <QWidget>

namespace pastoso::dialogs {

class CanvasSizePreview : public QWidget {
  public:
    /// `picture` is the painting of so many millimetres.
    CanvasSizePreview(const QImage& picture, const QSizeF& size_mm, QWidget* parent = nullptr);

    void show_margins(const tools::Margins& margins);

    QSize sizeHint() const override { return {230, 190}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QImage picture_;
    QSizeF size_mm_;
    tools::Margins margins_;
};

}  // namespace pastoso::dialogs

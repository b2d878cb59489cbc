// What the colours of a look mean, in a corner of the canvas.
#pragma once

#include "screen/look.hpp"

#include <QWidget>

namespace pastoso::view {

/// The words for a look; none for screen::Look::Lit.
QString look_words(screen::Look look);

/// Hidden while the paint is lit. Lets the pointer through.
class LookLegend : public QWidget {
    Q_OBJECT
  public:
    explicit LookLegend(QWidget* parent);

    void show_look(screen::Look look, double scale_top_mm);

    /// What it tells, line by line: the look, then the marks of its scale.
    const QStringList& lines() const { return lines_; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void paint_heights(QPainter& painter, const QRect& bar) const;
    void paint_wetness(QPainter& painter, const QRect& bar) const;

    screen::Look look_ = screen::Look::Lit;
    QStringList lines_;
};

}  // namespace pastoso::view

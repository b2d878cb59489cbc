// A frame around what a step of the tour speaks of.
#pragma once

#include <QList>
#include <QRect>
#include <QWidget>

namespace pastoso::help {

/// Lies over all of its parent, and takes no press: what it frames is used as ever.
class TourFrame : public QWidget {
    Q_OBJECT
  public:
    /// Hidden, over `parent`.
    explicit TourFrame(QWidget* parent);

    /// Frames these places in the parent, and nothing else.
    void show_around(const QList<QRect>& places);

  protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace pastoso::help

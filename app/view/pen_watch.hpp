// Whether a pen is still over a widget.
#pragma once

#include <QObject>

class QWidget;

namespace pastoso::view {

/// Notices what Qt does not tell the widget, as it does of a mouse: that a pen leaves it.
class PenWatch : public QObject {
    Q_OBJECT
  public:
    /// While both live.
    explicit PenWatch(QWidget& over);

    bool eventFilter(QObject* receiver, QEvent* event) override;

  Q_SIGNALS:
    /// A pen has left the tablet, or is over another widget, whether or not it was over this one.
    void pen_left();

  private:
    bool is_part(const QObject& receiver) const;

    QWidget& over_;
};

}  // namespace pastoso::view

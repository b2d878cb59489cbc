// Where the messages stand that need the painter: over the lower edge of the canvas, or of what is shown
// in its place.
#pragma once

#include "main/studio.hpp"

#include <QObject>
#include <QRect>

namespace pastoso::panels {
class MessageBar;
}

namespace pastoso::main {

/// The bar is the window's own: whatever hides what surrounds the canvas leaves it alone.
class MessagePlace : public QObject {
    Q_OBJECT
  public:
    explicit MessagePlace(Studio& studio);

    /// What of the canvas the bar leaves free, where the canvas lies.
    QRect free_canvas() const;

  Q_SIGNALS:
    void free_canvas_changed();

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    void place();

    Studio& studio_;
    panels::MessageBar* bar_;  ///< the window's
};

}  // namespace pastoso::main

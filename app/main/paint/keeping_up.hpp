// Tells the painter where the machine does not keep up with the paint, and offers what helps.
#pragma once

#include "main/studio.hpp"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace pastoso::panels {
class PaceNotice;
class StatusReadings;
}  // namespace pastoso::panels

namespace pastoso::main {

/// In the status bar, where messages pass: nothing moves, and nothing lies over the canvas.
class KeepingUp : public QObject {
    Q_OBJECT
  public:
    KeepingUp(Studio& studio, panels::StatusReadings* readings);

  private:
    panels::PaceNotice* make_notice() const;
    void look();
    void show();

    Studio& studio_;
    panels::StatusReadings* readings_;
    panels::PaceNotice* notice_;  ///< the window's
    QElapsedTimer clock_;
    QTimer looked_at_;
};

}  // namespace pastoso::main

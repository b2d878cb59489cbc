// The canvas' place in the window, while something else stands there and the painting waits.
#pragma once

#include "main/studio.hpp"

#include <functional>
#include <vector>

#include <QByteArray>
#include <QObject>
#include <QPointer>

namespace pastoso::panels {
class StatusReadings;
}

namespace pastoso::main {

class CanvasPlace : public QObject {
    Q_OBJECT
  public:
    CanvasPlace(Studio& studio, panels::StatusReadings* readings);

    /// Shows the page in place of the canvas, in a mode of its own and by its name; the painting stands
    /// still, as if it was paused, and its journal goes on. What stands there already is put away first.
    /// `put_away` is called when the page goes again.
    void take(QWidget* page, commands::Mode mode, const QString& name, std::function<void()> put_away);

    /// The painting comes back; nothing happens when it is there.
    void give_back();

    /// Adds a page, hidden.
    void add(QWidget* page);

  Q_SIGNALS:
    /// The canvas is about to go.
    void taking();
    /// What stands there now; empty: the canvas.
    void taken_by(const QString& name);

  private:
    void put_panels_away();
    void bring_panels_back();

    Studio& studio_;
    panels::StatusReadings* readings_;
    QWidget* page_ = nullptr;  ///< that is shown
    std::function<void()> put_away_;
    QByteArray panels_;  ///< how they stood
    std::vector<QPointer<QWidget>> hidden_, pages_;
};

}  // namespace pastoso::main

// The window with nothing in it but the canvas.
#pragma once

#include <vector>

#include <QByteArray>
#include <QObject>
#include <QPointer>

class QLabel;
class QMainWindow;
class QWidget;

namespace pastoso::main {

/// Hides all that stands around the canvas, and puts it back as it was. What would be told in the status
/// line meanwhile is told over the canvas.
class CanvasOnly : public QObject {
    Q_OBJECT
  public:
    /// `canvas` is in the central widget of `window`, which owns this.
    CanvasOnly(QMainWindow* window, QWidget* canvas);

    bool active() const { return active_; }
    void enter();
    void leave();

  private:
    std::vector<QWidget*> around_canvas() const;
    void tell(const QString& sentence);

    QMainWindow* window_;
    QWidget* canvas_;
    bool active_ = false;
    QByteArray panels_;  ///< how they stood
    std::vector<QPointer<QWidget>> hidden_;
    QLabel* note_;
};

}  // namespace pastoso::main

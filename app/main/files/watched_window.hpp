// A window in which a painting other than the one on the easel is seen, while it is being painted.
#pragma once

#include "interactions/navigate.hpp"
#include "view/canvas_view.hpp"

#include <QDialog>

namespace pastoso::main {

class WatchedWindow : public QDialog {
    Q_OBJECT
  public:
    view::CanvasView& canvas() { return *canvas_; }

  protected:
    /// `like` says in which light it is seen, and how it stands. It goes when it is closed.
    WatchedWindow(const QString& title, const view::CanvasView& like, QWidget* parent);

    ~WatchedWindow() override;

    /// Below the canvas, once.
    void add_controls(QWidget* controls);

  private:
    view::CanvasView* canvas_;
    interactions::Navigate navigate_;  ///< nothing is painted here
    interactions::FingerMove finger_move_;
};

}  // namespace pastoso::main

// A window in which a painting other than the one on the easel is seen, while it is being painted.
#pragma once

#include "tools/easel.hpp"
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
    tools::Easel easel_;  ///< holds no brush: nothing is painted here
    view::CanvasView* canvas_ = nullptr;
};

}  // namespace pastoso::main

// A window in which a painting is painted once more, to be watched; the one on the easel stays as it is.
#pragma once

#include "session/replayer.hpp"
#include "tools/easel.hpp"
#include "view/canvas_view.hpp"

#include <memory>

#include <QDialog>

class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace pastoso::main {

class ReplayWindow : public QDialog {
    Q_OBJECT
  public:
    /// `like` says in which light it is seen, and how it stands.
    ReplayWindow(document::Recording recording, const view::CanvasView& like, QWidget* parent);
    ~ReplayWindow() override;

    session::Replayer& replayer() { return *replayer_; }
    view::CanvasView& canvas() { return *canvas_; }

  private:
    QWidget* controls();
    void show_published();

    tools::Easel easel_;  ///< holds no brush: nothing is painted here
    view::CanvasView* canvas_ = nullptr;
    QToolButton* play_ = nullptr;
    QComboBox* speed_ = nullptr;
    QSlider* place_ = nullptr;
    QLabel* time_ = nullptr;
    std::unique_ptr<session::Replayer> replayer_;
};

}  // namespace pastoso::main

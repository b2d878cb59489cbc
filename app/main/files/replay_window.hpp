// A window in which a painting is painted once more, to be watched; the one on the easel stays as it is.
#pragma once

#include "main/files/watched_window.hpp"
#include "session/replayer.hpp"

#include <memory>

class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace pastoso::main {

class ReplayWindow : public WatchedWindow {
    Q_OBJECT
  public:
    /// `like` says in which light it is seen, and how it stands.
    ReplayWindow(document::Recording recording, const view::CanvasView& like, QWidget* parent);

    session::Replayer& replayer() { return *replayer_; }

  private:
    QWidget* controls();
    void show_published();

    QToolButton* play_ = nullptr;
    QComboBox* speed_ = nullptr;
    QSlider* place_ = nullptr;
    QLabel* time_ = nullptr;
    std::unique_ptr<session::Replayer> replayer_;
};

}  // namespace pastoso::main

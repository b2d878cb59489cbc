// A window in which a painting is painted again on finer cells, beside the one on the easel.
#pragma once

#include "main/files/watched_window.hpp"
#include "session/repainter.hpp"

#include <memory>
#include <string>
#include <utility>

class QLabel;
class QProgressBar;
class QPushButton;

namespace pastoso::main {

class RepaintWindow : public WatchedWindow {
    Q_OBJECT
  public:
    /// `name` stands for the painting in sentences; `like` says in which light it is seen.
    RepaintWindow(document::Recording strokes, const std::string& name, const view::CanvasView& like,
                  QWidget* parent);

    const session::Repainter& repainter() const { return *repainter_; }

    /// Whether what it paints may be lost, which the painter is asked unless it is kept elsewhere.
    bool may_go();
    /// It is kept elsewhere.
    void keep() { is_kept_ = true; }
    /// Closes it without a question.
    void let_go();

    /// A sentence beside the buttons, until there is another.
    void tell(const QString& sentence);
    void come_to_front();

    /// What paints, given up when the window closes: its end waits for the tick that it is at, which may
    /// take a while.
    std::unique_ptr<session::Repainter> take_repainter();

  Q_SIGNALS:
    /// The painter wants the whole painting on the easel, or in a file.
    void easel_wanted(const std::shared_ptr<const pastoso::project::Project>& painted);
    void file_wanted(const std::shared_ptr<const pastoso::project::Project>& painted);
    void closes();

  protected:
    void reject() override;
    void closeEvent(QCloseEvent* event) override;

  private:
    QWidget* controls();
    void show_published();

    QProgressBar* progress_ = nullptr;
    QLabel* time_ = nullptr;
    QPushButton* pause_ = nullptr;
    QPushButton* cancel_ = nullptr;
    QPushButton* save_ = nullptr;
    QPushButton* put_up_ = nullptr;
    bool is_kept_ = false;
    std::unique_ptr<session::Repainter> repainter_;
};

}  // namespace pastoso::main

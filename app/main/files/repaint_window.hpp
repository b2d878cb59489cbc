// A window in which a painting is painted again on finer cells, beside the one on the easel.
#pragma once

#include "session/repainter.hpp"
#include "tools/easel.hpp"
#include "view/canvas_view.hpp"

#include <memory>
#include <string>

#include <QDialog>

class QLabel;
class QProgressBar;
class QPushButton;

namespace pastoso::main {

class RepaintWindow : public QDialog {
    Q_OBJECT
  public:
    /// `name` stands for the painting in sentences; `like` says in which light it is seen.
    RepaintWindow(document::Recording strokes, const std::string& name, const view::CanvasView& like,
                  QWidget* parent);
    ~RepaintWindow() override;

    const session::Repainter& repainter() const { return *repainter_; }

    /// Closes it without a question: what it painted is elsewhere.
    void let_go();

  Q_SIGNALS:
    /// The painter wants the whole painting on the easel, or in a file.
    void easel_wanted(const std::shared_ptr<const pastoso::project::Project>& painted);
    void file_wanted(const std::shared_ptr<const pastoso::project::Project>& painted);

  protected:
    void reject() override;
    void closeEvent(QCloseEvent* event) override;

  private:
    QWidget* controls();
    void show_published();
    bool may_go();

    tools::Easel easel_;  ///< holds no brush: nothing is painted here
    view::CanvasView* canvas_ = nullptr;
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

// In the status bar: that the paint cannot be moved as fast as time is to pass, and what helps.
#pragma once

#include "session/paint_session.hpp"
#include "tools/pace.hpp"

#include <vector>

#include <QString>
#include <QWidget>

class QAction;
class QLabel;
class QPushButton;

namespace pastoso::panels {

/// Hidden while the paint keeps up or is paused.
class PaceNotice : public QWidget {
    Q_OBJECT
  public:
    struct Choice {
        QAction* action;
        QString words;            ///< of its button
        bool real_time = true;    ///< it helps where time is to pass as by the clock
        bool faster_time = true;  ///< it helps where it is to pass faster
    };

    explicit PaceNotice(const std::vector<Choice>& choices, QWidget* parent = nullptr);

    /// What the session tells at this moment, in seconds of a clock that does not run back.
    void look(const session::Status& status, double now_s);

    /// What it tells; empty while there is nothing to tell.
    const QString& sentence() const { return sentence_; }

  Q_SIGNALS:
    void sentence_changed();

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    struct Button {
        Choice choice;
        QPushButton* button;
    };

    void tell(tools::Pace pace, double speed);
    bool helps(const Choice& choice) const;
    void fit();
    void fill_menu();

    tools::PaceWatch watch_;
    std::vector<Button> buttons_;
    QLabel* words_;
    QPushButton* all_;  ///< opens a menu of all that helps
    QString sentence_;
    bool faster_ = false;  ///< whether time is to pass faster than by the clock
};

}  // namespace pastoso::panels

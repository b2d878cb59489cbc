// In the status bar: work that goes on beside the painting, how far it is, and a button to stop it.
#pragma once

#include <QWidget>

class QAction;
class QLabel;
class QProgressBar;

namespace pastoso::panels {

class WorkProgress : public QWidget {
    Q_OBJECT
  public:
    /// Hidden at first.
    explicit WorkProgress(QAction* stop, QWidget* parent = nullptr);

    void show_work(const QString& words, const QString& hint);
    void show_done(double done);  ///< 0 to 1

  private:
    QLabel* words_ = nullptr;
    QProgressBar* bar_ = nullptr;
};

}  // namespace pastoso::panels

// What was done to the painting, to go back and forth in.
#pragma once

#include "session/paint_session.hpp"

#include <QWidget>

class QLabel;
class QListView;

namespace pastoso::panels {

class HistoryModel;

class HistoryPanel : public QWidget {
    Q_OBJECT
  public:
    explicit HistoryPanel(QWidget* parent = nullptr);

    void show_steps(const session::Steps& steps, int budget_MiB);

  Q_SIGNALS:
    /// So many steps are to be undone, or, below 0, done again.
    void steps_back(int count);

  private:
    HistoryModel* model_;
    QListView* list_;
    QLabel* memory_;
};

}  // namespace pastoso::panels

// What is recorded of the painting so far, and what can be made of it.
#pragma once

#include <cstdint>
#include <vector>

#include <QWidget>

class QAction;
class QLabel;

namespace pastoso::panels {

/// Minutes and seconds, with hours where there are any.
QString time_words(double seconds);

class RecorderPanel : public QWidget {
    Q_OBJECT
  public:
    explicit RecorderPanel(const std::vector<QAction*>& actions, QWidget* parent = nullptr);

    void show_recorded(std::int64_t strokes, double painted_s);

  private:
    QLabel* strokes_ = nullptr;
    QLabel* time_ = nullptr;
};

}  // namespace pastoso::panels

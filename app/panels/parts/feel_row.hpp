// A slider between two words, such as stiff and runny.
#pragma once

#include <QWidget>

class QGridLayout;
class QSlider;

namespace pastoso::panels {

/// Adds a row to a grid: a word, the slider, the other word. Owned by the grid's widget.
class FeelRow : public QObject {
    Q_OBJECT
  public:
    FeelRow(QGridLayout* grid, const QString& name, const QString& from, const QString& to,
            const QString& hint);

    void show_place(double place);  ///< 0 to 1, without a signal

  Q_SIGNALS:
    void chosen(double place);

  private:
    QSlider* slider_ = nullptr;
};

}  // namespace pastoso::panels

// A number of the tea: a slider over what is usual, and a field that takes all that is allowed.
#pragma once

#include "panels/parts/slider_scale.hpp"

#include <QString>
#include <QWidget>

class QDoubleSpinBox;
class QGridLayout;
class QSlider;

namespace pastoso::glass {

struct NumberRange {
    double least = 0.0, most = 1.0;              ///< that may be typed
    double usual_least = 0.0, usual_most = 1.0;  ///< from end to end of the slider
    int decimals = 0;
    QString unit{};            ///< with the space before it
    bool logarithmic = false;  ///< the slider goes by equal factors; usual_least is above 0
};

/// Adds a row to a grid: a label, the slider, the number. Owned by the grid's widget.
class NumberRow : public QObject {
    Q_OBJECT
  public:
    NumberRow(QGridLayout* grid, const QString& name, const QString& words, const QString& hint,
              const NumberRange& range);

    /// Without a signal.
    void show_value(double value);

  Q_SIGNALS:
    void chosen(double value);

  private:
    void show_slider(double value);

    panels::SliderScale scale_;
    QSlider* slider_;
    QDoubleSpinBox* number_;
};

}  // namespace pastoso::glass

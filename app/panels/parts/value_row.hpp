// A slider with its number beside it: one control for a value that is dragged or typed.
#pragma once

#include "panels/parts/slider_scale.hpp"

#include <optional>

#include <QWidget>

class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QSlider;

namespace pastoso::panels {

struct ValueRange {
    double least = 0.0, most = 1.0;  ///< that may be typed
    int decimals = 0;
    QString unit{};            ///< with the space before it
    bool logarithmic = false;  ///< the slider goes by equal factors; its least value is above 0
    struct Usual {
        double least, most;
    };
    std::optional<Usual> usual{};  ///< from end to end of the slider, where that is not all
};

/// Adds a row to a grid: a label, the slider, the number. Owned by the grid's widget.
class ValueRow : public QObject {
    Q_OBJECT
  public:
    /// `name` is the number's object name; the slider's has "_slider" behind it.
    ValueRow(QGridLayout* grid, const QString& name, const QString& words, const QString& hint,
             const ValueRange& range);

    double value() const;

    /// Without a signal.
    void show_value(double value);

    void setEnabled(bool enabled);
    void setVisible(bool visible);

  Q_SIGNALS:
    void chosen(double value);

  private:
    void show_slider(double value);

    SliderScale scale_;
    QLabel* label_ = nullptr;
    QSlider* slider_ = nullptr;
    QDoubleSpinBox* number_ = nullptr;
};

}  // namespace pastoso::panels

// Asks for another size of the whole painting, in millimetres and in cells.
#pragma once

#include "dialogs/growing_dialog.hpp"
#include "document/events.hpp"

class QCheckBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;

namespace pastoso::dialogs {

class ScaleDialog : public GrowingDialog {
    Q_OBJECT
  public:
    explicit ScaleDialog(const document::CanvasSettings& canvas, QWidget* parent = nullptr);

    document::ScaleCanvas wanted() const;

  private:
    /// One number, what it was before, and how many times as much it was last set to be, exactly.
    struct Number {
        QDoubleSpinBox* box = nullptr;
        double before = 0.0;
        double set_change = 1.0;
        double change() const;
    };
    Number side(const QString& name, double value_mm);
    static Number number(QDoubleSpinBox* box, double value);
    void keep_proportions(const Number& typed, Number& other);
    void show_outcome();
    void show_possible(bool possible, const QString& words);

    document::CanvasSettings canvas_;
    Number width_, height_, density_;
    QCheckBox* proportions_ = nullptr;
    QLabel* summary_ = nullptr;
    QDialogButtonBox* buttons_ = nullptr;
};

}  // namespace pastoso::dialogs

// Asks which paint to select, by how high or how wet it stands; the window shows what it would be.
#pragma once

#include "dialogs/growing_dialog.hpp"
#include "document/actions/selection_actions.hpp"

class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace pastoso::dialogs {

struct SelectedRange {
    double least_mm = 0.0, most_mm = 0.0;
    grid::Combination how = grid::Combination::Replace;
};

class SelectRangeDialog : public GrowingDialog {
    Q_OBJECT
  public:
    /// `explanation` says what is measured; the range is what stands there first.
    SelectRangeDialog(const QString& title, const QString& explanation, const SelectedRange& proposal,
                      QWidget* parent = nullptr);

    SelectedRange chosen() const;

    /// What the choice comes to at present: a share of the canvas, or nothing at all.
    void show_outcome(double share, bool nothing);

  Q_SIGNALS:
    void changed();

  private:
    QDoubleSpinBox* add_thickness(const QString& name, double value_mm);

    QDoubleSpinBox* least_ = nullptr;
    QDoubleSpinBox* most_ = nullptr;
    QComboBox* how_ = nullptr;
    QLabel* outcome_ = nullptr;
};

}  // namespace pastoso::dialogs

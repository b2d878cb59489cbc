// Asks for one length.
#pragma once

#include "dialogs/growing_dialog.hpp"

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace pastoso::dialogs {

struct AskedLength {
    QString title;
    QString explanation;  ///< what the length is of
    QString name;         ///< stands beside it
    QString button;       ///< that does it
    double least_mm = 0.0, most_mm = 0.0;
    double proposal_mm = 0.0;
};

class LengthDialog : public GrowingDialog {
    Q_OBJECT
  public:
    explicit LengthDialog(const AskedLength& asked, QWidget* parent = nullptr);

    double chosen_mm() const;

    /// Why the length cannot be taken, in one sentence; empty: it can.
    void show_problem(const QString& sentence);

  Q_SIGNALS:
    void changed();

  private:
    QDoubleSpinBox* length_ = nullptr;
    QLabel* problem_ = nullptr;
    QPushButton* takes_ = nullptr;
};

// The manual has a page for each.

class MarginDialog : public LengthDialog {
    Q_OBJECT
  public:
    using LengthDialog::LengthDialog;
};

class ThicknessDialog : public LengthDialog {
    Q_OBJECT
  public:
    using LengthDialog::LengthDialog;
};

}  // namespace pastoso::dialogs

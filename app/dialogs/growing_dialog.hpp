// A dialog that is never lower than its words.
#pragma once

#include <QDialog>

namespace pastoso::dialogs {

/// As high as it needs when it comes up, whatever share of a low screen that is, and grows when what it
/// says becomes longer; it does not shrink again, so that its buttons stay where the
/// hand has found them.
class GrowingDialog : public QDialog {
    Q_OBJECT
  public:
    using QDialog::QDialog;

  protected:
    bool event(QEvent* event) override;
};

}  // namespace pastoso::dialogs

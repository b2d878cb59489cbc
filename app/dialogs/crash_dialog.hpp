// Shows the report that the run before left when it failed.
#pragma once

#include "dialogs/growing_dialog.hpp"

namespace pastoso::dialogs {

class CrashDialog : public GrowingDialog {
    Q_OBJECT
  public:
    /// `file` is where the report lies.
    CrashDialog(const QString& report, const QString& file, QWidget* parent = nullptr);
};

}  // namespace pastoso::dialogs

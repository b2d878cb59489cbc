// Shows the report that the run before left when it failed.
#pragma once

#include <QDialog>

namespace pastoso::dialogs {

class CrashDialog : public QDialog {
    Q_OBJECT
  public:
    /// `file` is where the report lies.
    CrashDialog(const QString& report, const QString& file, QWidget* parent = nullptr);
};

}  // namespace pastoso::dialogs

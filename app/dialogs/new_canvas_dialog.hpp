// Asks for the size and the support of a fresh canvas.
#pragma once

#include "document/events.hpp"

#include <QDialog>

class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;

namespace pastoso::dialogs {

class NewCanvasDialog : public QDialog {
    Q_OBJECT
  public:
    explicit NewCanvasDialog(const document::CanvasSettings& proposal, QWidget* parent = nullptr);

    document::CanvasSettings settings() const;

  private:
    QDoubleSpinBox* add_number(double lowest, double highest, double value, const QString& suffix);
    void choose_image();
    void write_summary();

    QDoubleSpinBox* width_ = nullptr;
    QDoubleSpinBox* height_ = nullptr;
    QDoubleSpinBox* density_ = nullptr;
    QComboBox* support_ = nullptr;
    QString image_path_;
    QLabel* summary_ = nullptr;
    QDialogButtonBox* buttons_ = nullptr;
};

}  // namespace pastoso::dialogs

// Asks for the size and the support of a fresh canvas.
#pragma once

#include "dialogs/growing_dialog.hpp"
#include "document/events.hpp"

#include <optional>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;

namespace pastoso::dialogs {

class NewCanvasDialog : public GrowingDialog {
    Q_OBJECT
  public:
    /// `live_px_per_mm`: the finest cells on which this machine keeps pace with the hand.
    NewCanvasDialog(const document::CanvasSettings& proposal, double live_px_per_mm,
                    QWidget* parent = nullptr);

    document::CanvasSettings settings() const;

    /// How thick the toned ground is to be while it is wet; none is wanted otherwise.
    std::optional<double> ground_mm() const;

  private:
    QDoubleSpinBox* add_side(const QString& name, double value_mm);
    void add_ground();
    void choose_image();
    QString pace_words(double px_per_mm) const;
    void write_summary();

    double live_px_per_mm_;
    QDoubleSpinBox* width_ = nullptr;
    QDoubleSpinBox* height_ = nullptr;
    QDoubleSpinBox* density_ = nullptr;
    QComboBox* support_ = nullptr;
    QCheckBox* toned_ = nullptr;
    QDoubleSpinBox* ground_ = nullptr;
    QString image_path_;
    QLabel* summary_ = nullptr;
    QDialogButtonBox* buttons_ = nullptr;
};

}  // namespace pastoso::dialogs

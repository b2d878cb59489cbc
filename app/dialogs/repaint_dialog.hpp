// Asks on how fine cells a painting is to be painted again.
#pragma once

#include "dialogs/growing_dialog.hpp"
#include "project/repainting.hpp"

#include <string>

class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;

namespace pastoso::dialogs {

class RepaintDialog : public GrowingDialog {
    Q_OBJECT
  public:
    /// `name` stands for the painting in sentences.
    RepaintDialog(document::Recording strokes, std::string name, QWidget* parent = nullptr);

    /// On the canvas that was chosen, when it was accepted.
    const document::Recording& strokes() const { return strokes_; }

  private:
    void show_outcome();
    void show_possible(bool possible, const QString& words);

    document::Recording strokes_;
    std::string name_;
    QDoubleSpinBox* px_per_mm_ = nullptr;
    QLabel* summary_ = nullptr;
    QDialogButtonBox* buttons_ = nullptr;
};

}  // namespace pastoso::dialogs

// Asks how far the whole painting is to be turned.
#pragma once

#include "dialogs/growing_dialog.hpp"
#include "document/events.hpp"

#include <optional>

#include <QImage>

class QCheckBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;

namespace pastoso::dialogs {

class CanvasSizePreview;

class RotateDialog : public GrowingDialog {
    Q_OBJECT
  public:
    /// `picture` is the painting, small. With a ruler a button turns as far as it takes to put that
    /// straight.
    RotateDialog(const document::CanvasSettings& canvas, const QImage& picture,
                 const std::optional<brush::Ruler>& ruler, QWidget* parent = nullptr);

    document::RotateCanvas wanted() const;

  private:
    void show_outcome();
    void show_possible(bool possible, const QString& words);

    document::CanvasSettings canvas_;
    CanvasSizePreview* preview_ = nullptr;
    QDoubleSpinBox* turn_ = nullptr;
    QCheckBox* keeps_size_ = nullptr;
    QLabel* summary_ = nullptr;
    QDialogButtonBox* buttons_ = nullptr;
};

}  // namespace pastoso::dialogs

// Asks for another size of the canvas, and which part of it stays where it is.
#pragma once

#include "dialogs/growing_dialog.hpp"
#include "document/events.hpp"
#include "tools/canvas_resizing.hpp"

#include <QImage>

class QButtonGroup;
class QDialogButtonBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;

namespace pastoso::dialogs {

class CanvasSizePreview;

class CanvasSizeDialog : public GrowingDialog {
    Q_OBJECT
  public:
    /// `picture` is the painting, small.
    CanvasSizeDialog(const document::CanvasSettings& canvas, const QImage& picture,
                     QWidget* parent = nullptr);

    document::ResizeCanvas wanted() const;

  private:
    QDoubleSpinBox* add_side(const QString& name, double value_mm);
    QGridLayout* make_anchors();
    void show_outcome();
    QString problem() const;
    void show_possible(bool possible, const QString& words);

    document::CanvasSettings canvas_;
    QDoubleSpinBox* width_ = nullptr;
    QDoubleSpinBox* height_ = nullptr;
    QButtonGroup* anchors_ = nullptr;
    CanvasSizePreview* preview_ = nullptr;
    QLabel* summary_ = nullptr;
    QDialogButtonBox* buttons_ = nullptr;
};

}  // namespace pastoso::dialogs

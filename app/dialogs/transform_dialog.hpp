// The frame around a layer's paint in numbers; the canvas shows it at the same time.
#pragma once

#include "dialogs/growing_dialog.hpp"
#include "tools/transform_frame.hpp"

#include <utility>

#include <QSizeF>

class QDialogButtonBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QToolButton;

namespace pastoso::dialogs {

class TransformDialog : public GrowingDialog {
    Q_OBJECT
  public:
    /// `canvas_mm`: what comes to lie beyond it is told.
    TransformDialog(const tools::TransformFrame& frame, const QSizeF& canvas_mm,
                    QWidget* parent = nullptr);

    /// The same frame after it was dragged.
    void show_frame(const tools::TransformFrame& frame);
    const tools::TransformFrame& frame() const { return frame_; }

  Q_SIGNALS:
    /// A number was chosen by the painter.
    void changed(const tools::TransformFrame& frame);

  private:
    QDoubleSpinBox* add_number(QFormLayout* form, QDoubleSpinBox* box, const QString& words,
                               std::pair<double, double> range);
    QToolButton* make_mirror(const QString& name, const QString& words, const QString& hint);
    void read_numbers();
    void show_outcome();

    tools::TransformFrame frame_;
    QSizeF canvas_mm_;
    QDoubleSpinBox *move_x_ = nullptr, *move_y_ = nullptr;
    QDoubleSpinBox *width_ = nullptr, *height_ = nullptr;
    QDoubleSpinBox* turn_ = nullptr;
    QToolButton *mirror_x_ = nullptr, *mirror_y_ = nullptr;
    QLabel* outcome_ = nullptr;
    QDialogButtonBox* buttons_ = nullptr;
};

}  // namespace pastoso::dialogs

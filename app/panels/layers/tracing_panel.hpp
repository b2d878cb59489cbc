// The picture that is traced: beside the canvas to look at, and how it lies below the paint.
#pragma once

#include "document/actions/picture_actions.hpp"
#include "layers/tracing.hpp"

#include <memory>
#include <vector>

#include <QTimer>
#include <QWidget>

class QAction;
class QDoubleSpinBox;

namespace pastoso::panels {

class PictureBoard;
class ValueRow;

class TracingPanel : public QWidget {
    Q_OBJECT
  public:
    /// Buttons below the picture, and below its place.
    TracingPanel(const std::vector<QAction*>& picture, const std::vector<QAction*>& place,
                 QWidget* parent = nullptr);

    /// Shows the painting's; null: none. Without a signal.
    void show_tracing(const std::shared_ptr<const layers::Tracing>& tracing);

    /// Says at once what was set a moment ago.
    void finish();

  Q_SIGNALS:
    /// A value moves, then rests: every rest is a step that Undo returns to.
    void moved(const document::SetTracing& tracing);
    void rested(const document::SetTracing& tracing);

    void colour_picked(const QColor& colour);

  private:
    void make_rows(QWidget* parent);
    void show_values();
    void value_chosen();
    document::SetTracing chosen() const;

    std::shared_ptr<const layers::Tracing> shown_;
    PictureBoard* board_ = nullptr;
    ValueRow* opacity_ = nullptr;
    QDoubleSpinBox *x_ = nullptr, *y_ = nullptr, *width_ = nullptr;
    QTimer resting_;
};

}  // namespace pastoso::panels

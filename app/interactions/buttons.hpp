// What the right button of a mouse and the buttons on a pen do.
#pragma once

#include "tools/picked_paint.hpp"
#include "view/canvas_view.hpp"

#include <QObject>

namespace pastoso::interactions {

/// They do it at once: the tip stays free.
class Buttons : public QObject, public view::Interaction {
    Q_OBJECT
  public:
    explicit Buttons(view::CanvasView& canvas) : canvas_(canvas) {}

    view::Took press(const input::PointerEvent& event) override;

  Q_SIGNALS:
    /// The pop-up palette is to open there on the desktop.
    void palette_wanted(const QPoint& place);

    /// The paint, or the colour, at this place is asked for.
    void picked(const QPointF& place_mm, tools::Pick pick);

    /// The command of that name.
    void command_wanted(const QString& name);

  private:
    view::CanvasView& canvas_;
};

}  // namespace pastoso::interactions

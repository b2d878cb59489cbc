// The guides over the canvas, and the handles by which they are dragged.
#pragma once

#include "interactions/guide_drag.hpp"
#include "view/canvas_view.hpp"

#include <QObject>

namespace pastoso::interactions {

class Guides : public QObject, public view::Interaction {
    Q_OBJECT
  public:
    Guides(view::CanvasView& canvas, const tools::Easel& easel) : canvas_(canvas), easel_(easel) {}

    void show_handles(bool shown);

    view::Took press(const input::PointerEvent& event) override;
    void drag(const input::PointerEvent& event) override;
    void release(const input::PointerEvent& /*event*/) override { drag_.release(); }
    void cancel() override { drag_.release(); }
    void draw(const view::Overlay& overlay) override;

  Q_SIGNALS:
    void dragged(const tools::Guide& guide);

  private:
    void draw_handles(const view::Overlay& overlay) const;

    view::CanvasView& canvas_;
    const tools::Easel& easel_;
    GuideDrag drag_;
    bool handles_shown_ = true;
};

}  // namespace pastoso::interactions

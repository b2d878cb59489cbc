// The brush: paints where the pointer presses, and shows how it is held.
#pragma once

#include "interactions/brush_outline.hpp"
#include "interactions/wet_mark.hpp"
#include "view/canvas_view.hpp"

#include <optional>

#include <QObject>
#include <QTimer>

namespace pastoso::interactions {

class Paint : public QObject, public view::Interaction {
    Q_OBJECT
  public:
    /// `easel` is told of every stroke, as one on `surface`.
    Paint(view::CanvasView& canvas, tools::Easel& easel, document::Surface surface);

    void set_tool(const brush::Preset& tool);  ///< whose outline goes with the pointer
    void set_paint(const PaintInHand& paint) { mark_.set_paint(paint); }

    /// The easel's action waits under this number for the painting.
    void note_posted(const document::Action& action, std::uint64_t number);
    /// It waits for another painting no more.
    void forget_posted() { mark_.clear(); }

    view::Took press(const input::PointerEvent& event) override;
    void drag(const input::PointerEvent& event) override;
    void release(const input::PointerEvent& event) override;
    void cancel() override;
    void hover(const input::PointerEvent& event) override { drag(event); }
    void draw(const view::Overlay& overlay) override;

  Q_SIGNALS:
    /// The brush has come down on the canvas.
    void stroke_begun(const QPointF& canvas_mm);
    /// The frame that is drawn now has a wet mark of all that was posted.
    void marked();

  private:
    bool marks() const;
    bool may_touch_nothing(const tools::Pointer& pointer) const;
    void draw_line(const view::Overlay& overlay, const glm::dvec2& end_mm) const;

    view::CanvasView& canvas_;
    tools::Easel& easel_;
    document::Surface surface_;
    BrushOutline outline_;
    WetMark mark_;
    QTimer waiting_;         ///< since the pointer moved
    double pressure_ = 0.0;  ///< the latest
};

}  // namespace pastoso::interactions

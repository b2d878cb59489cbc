// The hand moves the canvas on the screen, and not the brush.
#pragma once

#include "view/canvas_view.hpp"

#include <optional>

namespace pastoso::interactions {

/// The middle button, or Space and a press: pans; with Shift it turns the canvas, with Control it zooms.
class Navigate : public view::Interaction {
  public:
    /// `turns`: whether the canvas can be turned.
    Navigate(view::CanvasView& canvas, bool turns) : canvas_(canvas), turns_(turns) {}

    view::Took press(const input::PointerEvent& event) override;
    void drag(const input::PointerEvent& event) override;
    void release(const input::PointerEvent& event) override;
    void cancel() override { drag_.reset(); }
    bool key(const QKeyEvent& event) override;
    void keys_lost() override { space_held_ = false; }
    std::optional<QCursor> cursor() const override;
    bool is_mode() const override { return space_held_; }

    /// Whatever has been pressed, a drag begins.
    void begin(const input::PointerEvent& event);

  private:
    struct Drag {
        enum class Kind { Pan, Turn, Zoom } kind;
        QPointF from;
        screen::ViewTransform start;
    };

    bool is_meant(const input::PointerEvent& event) const;
    void turn(const QPointF& place, bool by_steps);

    view::CanvasView& canvas_;
    bool turns_;
    std::optional<Drag> drag_;
    bool space_held_ = false;
};

/// A finger that does not paint, and has found nothing else to take hold of, moves the canvas.
class FingerMove : public view::Interaction {
  public:
    FingerMove(view::CanvasView& canvas, Navigate& navigate) : canvas_(canvas), navigate_(navigate) {}

    view::Took press(const input::PointerEvent& event) override;
    void drag(const input::PointerEvent& event) override { navigate_.drag(event); }
    void release(const input::PointerEvent& event) override { navigate_.release(event); }
    void cancel() override { navigate_.cancel(); }

  private:
    view::CanvasView& canvas_;
    Navigate& navigate_;
};

}  // namespace pastoso::interactions

// A press and a drag draw the line of a gradient.
#pragma once

#include "view/canvas_view.hpp"

#include <optional>

#include <QObject>
#include <glm/vec2.hpp>

namespace pastoso::interactions {

class GradientLine : public QObject, public view::Interaction {
    Q_OBJECT
  public:
    explicit GradientLine(view::CanvasView& canvas) : canvas_(canvas) {}

    void draw_next(bool on);  ///< off: presses paint

    view::Took press(const input::PointerEvent& event) override;
    /// With Shift level, upright or halfway between.
    void drag(const input::PointerEvent& event) override;
    void release(const input::PointerEvent& event) override;
    void cancel() override;

    /// Escape gives up the line that is being drawn, or else goes back to painting.
    bool key(const QKeyEvent& event) override;
    void draw(const view::Overlay& overlay) override;
    bool is_mode() const override { return on_; }

  Q_SIGNALS:
    /// Millimetres on the canvas; none but a click, or not meant.
    void drawn(const glm::dvec2& from_mm, const glm::dvec2& to_mm);
    void cancelled();
    void left();  ///< painting goes on

  private:
    struct Line {
        glm::dvec2 from_mm, to_mm;
    };

    view::CanvasView& canvas_;
    bool on_ = false;
    std::optional<Line> line_;
};

}  // namespace pastoso::interactions

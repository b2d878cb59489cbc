// A frame over the canvas that presses and drags move, scale, turn and distort.
#pragma once

#include "tools/transform_frame.hpp"
#include "view/canvas_view.hpp"

#include <cstddef>
#include <optional>

#include <QImage>
#include <QObject>

namespace pastoso::interactions {

class Frame : public QObject, public view::Interaction {
    Q_OBJECT
  public:
    explicit Frame(view::CanvasView& canvas);

    /// Nothing: presses paint.
    void show(std::optional<tools::TransformFrame> frame);
    const std::optional<tools::TransformFrame>& shown() const { return frame_; }

    /// The corner that keys have chosen, as a place among tools::kFrameCorners.
    std::optional<std::size_t> corner() const { return corner_; }

    /// What is drawn in the frame, from corner to corner, however it is dragged: its paint, flat. Where
    /// it lies as yet `below` covers it, as large: what would be seen there without it. Paint is seen
    /// only where `open`, of the whole canvas, is opaque; null: everywhere.
    void show_picture(const QImage& picture, const QImage& below, const QImage& open);

    view::Took press(const input::PointerEvent& event) override;
    void drag(const input::PointerEvent& event) override;
    void release(const input::PointerEvent& event) override;
    void cancel() override;

    /// Enter keeps what the frame shows; Escape gives up the drag, or else the frame. Tab chooses the
    /// next corner, after the last none, and 1 to 4 choose one; arrows move it by a pixel, with Shift by
    /// ten.
    bool key(const QKeyEvent& event) override;
    bool needs_key(const QKeyEvent& event) const override;
    void hover(const input::PointerEvent& event) override;
    void draw(const view::Overlay& overlay) override;
    std::optional<QCursor> cursor() const override;
    bool is_mode() const override { return frame_.has_value(); }

  Q_SIGNALS:
    /// It was dragged; what it shows is to be kept; it is to be taken away.
    void dragged(const tools::TransformFrame& frame);
    void accepted();
    void cancelled();

    void corner_chosen();  ///< corner()
    void corner_moved();   ///< by keys

  private:
    /// Since the press.
    struct Drag {
        tools::TransformFrame start;
        tools::FrameHold hold;
        glm::dvec2 from_mm{};
    };

    tools::FrameHold hold_at(const input::PointerEvent& event) const;
    void take_unless_folded(const tools::TransformFrame& wanted);
    void choose_corner(std::optional<std::size_t> corner);
    void move_corner(const QPointF& way_px);
    void key_of_corner(const QKeyEvent& event);
    void take_screen_colours();
    void draw_picture(const view::Overlay& overlay) const;
    tools::TransformFrame whole_canvas() const;
    QImage paint_on_open() const;
    void draw_in(const view::Overlay& overlay, const tools::TransformFrame& frame, const QImage& picture,
                 double opacity) const;

    view::CanvasView& canvas_;
    std::optional<tools::TransformFrame> frame_;
    std::optional<Drag> drag_;
    std::optional<std::size_t> corner_;
    tools::FrameHold under_;  ///< the pointer
    QImage picture_, below_, open_;
    QImage shown_, veil_;  ///< in the colours of the screen
};

}  // namespace pastoso::interactions

// A frame over the canvas that presses and drags move, scale, turn and distort.
#pragma once

#include "tools/transform_frame.hpp"
#include "view/canvas_view.hpp"

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

    /// What is drawn in the frame, from corner to corner, however it is dragged: its paint, flat. Where
    /// it lies as yet `below` covers it, as large: what would be seen there without it. Paint is seen
    /// only where `open`, of the whole canvas, is opaque; null: everywhere.
    void show_picture(const QImage& picture, const QImage& below, const QImage& open);

    view::Took press(const input::PointerEvent& event) override;
    void drag(const input::PointerEvent& event) override;
    void release(const input::PointerEvent& event) override;
    void cancel() override;

    /// Enter keeps what the frame shows; Escape gives up the drag, or else the frame.
    bool key(const QKeyEvent& event) override;
    void hover(const input::PointerEvent& event) override;
    void draw(const view::Overlay& overlay) override;
    std::optional<QCursor> cursor() const override;
    bool is_mode() const override { return frame_.has_value(); }

  Q_SIGNALS:
    /// It was dragged; what it shows is to be kept; it is to be taken away.
    void dragged(const tools::TransformFrame& frame);
    void accepted();
    void cancelled();

  private:
    /// Since the press.
    struct Drag {
        tools::TransformFrame start;
        tools::FrameHold hold;
        glm::dvec2 from_mm{};
    };

    tools::FrameHold hold_at(const input::PointerEvent& event) const;
    void take_screen_colours();
    void draw_picture(const view::Overlay& overlay) const;
    tools::TransformFrame whole_canvas() const;
    QImage paint_on_open() const;
    void draw_in(const view::Overlay& overlay, const tools::TransformFrame& frame, const QImage& picture,
                 double opacity) const;

    view::CanvasView& canvas_;
    std::optional<tools::TransformFrame> frame_;
    std::optional<Drag> drag_;
    tools::FrameHold under_;  ///< the pointer
    QImage picture_, below_, open_;
    QImage shown_, veil_;  ///< in the colours of the screen
};

}  // namespace pastoso::interactions

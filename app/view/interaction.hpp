// One thing that the pointer can do over a canvas: paint, pick, drag a frame, move the canvas ...
#pragma once

#include "input/pointer_event.hpp"
#include "screen/overlay_painter.hpp"

#include <optional>

#include <QCursor>

class QKeyEvent;

namespace pastoso::view {

/// What is drawn over the picture.
struct Overlay {
    screen::OverlayPainter& painter;
    screen::OverlayFrame canvas;  ///< its millimetres
    double px_mm = 0.0;           ///< a pixel of the layout

    /// Millimetres from a place on the canvas.
    screen::OverlayFrame around(const glm::dvec2& place_mm) const;
};

/// What came of a press that was offered: nothing; all there was to do is done; or the pointer belongs
/// to who took it until it is released or cancelled.
enum class Took { Nothing, Press, Pointer };

/// A canvas offers each press to its interactions in turn.
class Interaction {
  public:
    virtual ~Interaction() = default;

    virtual Took press(const input::PointerEvent& event) = 0;
    virtual void drag(const input::PointerEvent& /*event*/) {}
    virtual void release(const input::PointerEvent& /*event*/) {}
    virtual void cancel() {}

    /// The pointer moves and nobody has it.
    virtual void hover(const input::PointerEvent& /*event*/) {}

    /// Whether the key, pressed or released, is its own.
    virtual bool key(const QKeyEvent& /*event*/) { return false; }
    /// Whether the key is its own now, even where it is a command's otherwise.
    virtual bool needs_key(const QKeyEvent& /*event*/) const { return false; }
    virtual void keys_lost() {}  ///< the keyboard is another's

    /// Draws what it shows over the canvas.
    virtual void draw(const Overlay& /*overlay*/) {}

    /// Nothing: that of the next.
    virtual std::optional<QCursor> cursor() const { return std::nullopt; }

    /// Whether no press reaches those behind it now: the brush rests.
    virtual bool is_mode() const { return false; }
};

}  // namespace pastoso::view

// What draws a canvas into its view: the graphics card, or the processor where there is none to be had.
#pragma once

#include "graphics/opengl_support.hpp"
#include "screen/canvas_presenter.hpp"
#include "screen/overlay_painter.hpp"
#include "screen/view_transform.hpp"

#include <memory>

#include <QImage>
#include <QOpenGLWidget>

namespace pastoso::screen {

/// What a screen asks of the view that it fills, and tells it.
class ScreenHost {
  public:
    virtual Sight sight() const = 0;  ///< to be seen; nothing while it has no painting
    virtual const ViewTransform& view_transform() const = 0;

    /// Draws over the picture of this painting.
    virtual void draw_over(const document::Snapshot& shown, OverlayPainter& painter) = 0;

    /// The scale of colours of Look::Height ends here from now on.
    virtual void scale_shown(double top_mm) = 0;

    /// A frame has come to the screen.
    virtual void frame_shown() = 0;

    /// The screen shows nothing more; why, in one sentence.
    virtual void screen_failed(const QString& sentence) = 0;

  protected:
    ~ScreenHost() = default;
};

/// All calls come from the window's thread.
class CanvasScreen {
  public:
    virtual ~CanvasScreen() = default;

    /// Lets pointer and keys through to the view below it.
    virtual QWidget& widget() = 0;

    /// What is to be seen, or from where, may be another.
    virtual void refresh() = 0;

    /// Nothing of what was shown is on this canvas.
    virtual void begin_other_canvas() = 0;

    /// All of the picture is out of date.
    virtual void damage_all() = 0;

    /// Whether the frame on the screen is the final one of what is to be seen.
    virtual bool finished() const = 0;

    /// What the latest frame showed; null before the first.
    virtual const document::Snapshot* shown() const = 0;

    /// The frame of now.
    virtual QImage picture() = 0;

    /// Null where the processor draws.
    virtual QOpenGLWidget* opengl() { return nullptr; }
};

/// Fastest: by OpenGL, but by the processor where that would do the graphics card's work.
enum class DrawnBy { Fastest, OpenGl, Processor };

/// Whether the processor draws a canvas of so many cells. Fastest: textures of more than 32 million
/// would be seen many seconds later, and take gigabytes.
bool drawn_by_processor(DrawnBy drawn_by, const graphics::OpenGlSupport& opengl, double cells);

/// The processor's, too, where OpenGL is not to be had.
std::unique_ptr<CanvasScreen> make_screen(DrawnBy drawn_by, ScreenHost& host, QWidget& parent);

}  // namespace pastoso::screen

// The shaded window as it was last drawn, kept on the graphics card: only what changed is shaded again.
#pragma once

#include "graphics/picture_finish.hpp"
#include "screen/quality.hpp"
#include "screen/scene.hpp"
#include "screen/shading_uniforms.hpp"
#include "screen/squint_pass.hpp"

#include <map>
#include <memory>
#include <utility>

#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>
#include <QOpenGLShaderProgram>
#include <QRect>
#include <QSize>

namespace pastoso::screen {

/// All calls need the current context that initialise() was called in. Rectangles are in device pixels
/// with y down.
class PictureBuffer {
  public:
    /// Throws graphics::GraphicsFault when the driver refuses the shaders.
    void initialise(QOpenGLExtraFunctions* gl);
    void release();

    /// Makes the program for a look, which else is made when it is first shaded. Throws as initialise().
    void prepare(Look look);

    /// Forgets the picture when the size is another.
    void resize(QSize window_px, const Rgb& ground);
    QSize size() const { return size_; }

    /// Shows what it shows from one place as it is seen from another, as good as that is; the ground
    /// where nothing of it comes to lie. Exact where it moves by whole pixels.
    void move(const ViewTransform& from, const ViewTransform& to, const Rgb& ground);

    /// Shades a part of the window.
    void shade(const QRect& part, Quality quality, const Scene& scene);

    /// Draws the whole picture into the framebuffer given, in the colours and levels of the screen, and
    /// leaves that bound. A blur of more than 0 is that of half-closed eyes (squint.hpp).
    void finish(const appearance::ScreenCube& cube, double squint_px, GLuint framebuffer);

  private:
    /// The program for a look, and whether that draws outlines.
    using ProgramKind = std::pair<Look, bool>;

    QOpenGLShaderProgram& program_of(const ProgramKind& kind);
    void draw(const QRegion& parts, QOpenGLFramebufferObject& target, const Sampling& sampling,
              const Scene& scene, bool outlined);
    void enlarge_coarse(const QRect& coarse, const QRect& part);

    QOpenGLExtraFunctions* gl_ = nullptr;
    QSize size_;
    std::map<ProgramKind, std::unique_ptr<QOpenGLShaderProgram>> programs_;  ///< made when wanted
    // Both hold the window's top row first, in 16 bits: what the screen makes of them comes last and is
    // alike for what is drawn anew and what is kept. Alpha is the share of canvas, the rest is ground.
    std::unique_ptr<QOpenGLFramebufferObject> picture_;
    std::unique_ptr<QOpenGLFramebufferObject> coarse_;
    std::unique_ptr<QOpenGLFramebufferObject> spare_;  ///< as large as the picture; made when it moves
    std::unique_ptr<QOpenGLShaderProgram> move_program_;  ///< the same
    SquintPass squint_;
    graphics::PictureFinish finish_;
    GLuint vertex_array_ = 0;
};

}  // namespace pastoso::screen

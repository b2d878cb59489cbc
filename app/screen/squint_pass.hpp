// What the graphics card makes of a picture for half-closed eyes (squint.hpp).
#pragma once

#include <memory>

#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>
#include <QOpenGLShaderProgram>
#include <QSize>

namespace pastoso::screen {

/// All calls need the current context that initialise() was called in.
class SquintPass {
  public:
    void initialise(QOpenGLExtraFunctions* gl);
    void release();

    /// The picture of encoded light and a share, blurred: another texture of its size, which is there
    /// until the next call. Throws graphics::GraphicsFault when the driver refuses the shaders.
    GLuint squinted(GLuint picture, const QSize& size, double blur_px);

  private:
    using Program = std::unique_ptr<QOpenGLShaderProgram>;
    using Target = std::unique_ptr<QOpenGLFramebufferObject>;

    void prepare(const QSize& size);
    void blur(GLuint squares, const QPoint& step, double blur_px, bool encodes, Target& target);
    void draw(QOpenGLShaderProgram& program, GLuint texture, QOpenGLFramebufferObject& target);

    QOpenGLExtraFunctions* gl_ = nullptr;
    Program gather_, blur_, spread_;  ///< made when wanted
    Target squares_, spare_;          ///< linear light, a texel for each square
    Target picture_;
    GLuint vertex_array_ = 0;
};

}  // namespace pastoso::screen

// Brings a picture on the graphics card into the window, in the colours and levels of the screen.
#pragma once

#include "appearance/screen_colours.hpp"

#include <memory>

#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QSize>

namespace pastoso::graphics {

/// All calls need the current context that initialise() was called in.
class PictureFinish {
  public:
    /// Throws a GraphicsFault when the driver refuses the shader.
    void initialise(QOpenGLExtraFunctions* gl);
    void release();

    /// Draws a picture, its top row first, into the framebuffer and leaves that bound. Its alpha is the
    /// share of it that goes through the cube.
    void draw(GLuint picture, const QSize& size, const appearance::ScreenCube& cube, GLuint framebuffer);

  private:
    void upload(const appearance::ScreenCube& cube);

    QOpenGLExtraFunctions* gl_ = nullptr;
    std::unique_ptr<QOpenGLShaderProgram> program_;
    GLuint vertex_array_ = 0;
    GLuint cube_ = 0;
    appearance::ScreenCube uploaded_;
};

}  // namespace pastoso::graphics

#include "graphics/graphics_fault.hpp"

#include <string>

namespace pastoso::graphics {
namespace {

std::string name_of(GLenum error) {
    switch (error) {
        case GL_OUT_OF_MEMORY:
            return "its memory does not suffice";
        case GL_CONTEXT_LOST:
            return "it was reset";
        default:
            return "OpenGL reports error " + std::to_string(error);
    }
}

}  // namespace

std::unique_ptr<QOpenGLShaderProgram> shader_program(const QByteArray& vertex,
                                                     const QByteArray& fragment) {
    auto program = std::make_unique<QOpenGLShaderProgram>();
    const bool linked = program->addShaderFromSourceCode(QOpenGLShader::Vertex, vertex) &&
                        program->addShaderFromSourceCode(QOpenGLShader::Fragment, fragment) &&
                        program->link();
    if (!linked) {
        throw GraphicsFault("The graphics driver refuses a program that pictures are drawn with: " +
                            program->log().simplified().toStdString());
    }
    return program;
}

void expect_no_error(QOpenGLExtraFunctions& gl) {
    constexpr int kMostErrors = 16;
    const GLenum error = gl.glGetError();
    if (error == GL_NO_ERROR) return;
    // The others are about the same; a lost context never ends reporting.
    for (int i = 0; i < kMostErrors && gl.glGetError() != GL_NO_ERROR; ++i) {
    }
    throw GraphicsFault("The graphics card cannot draw the canvas: " + name_of(error) + ".");
}

}  // namespace pastoso::graphics

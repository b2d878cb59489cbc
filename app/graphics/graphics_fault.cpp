#include "graphics/graphics_fault.hpp"

namespace pastoso::graphics {
namespace {

core::Message reason_of(GLenum error) {
    switch (error) {
        case GL_OUT_OF_MEMORY:
            return core::message("its memory does not suffice");
        case GL_CONTEXT_LOST:
            return core::message("it was reset");
        default:
            return core::message("OpenGL reports error %1", error);
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
        throw GraphicsFault("The graphics driver refuses a program that pictures are drawn with: %1",
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
    throw GraphicsFault("The graphics card cannot draw the canvas: %1.", reason_of(error));
}

}  // namespace pastoso::graphics

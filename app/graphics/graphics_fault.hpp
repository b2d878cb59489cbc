// What goes wrong on the way to the graphics card.
#pragma once

#include "core/error.hpp"

#include <memory>

#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>

namespace pastoso::graphics {

/// The driver refuses what is asked of it, or has lost it; one sentence.
class GraphicsFault : public core::InputError {
    using core::InputError::InputError;
};

/// A program of these two shaders, in the current context. Throws a GraphicsFault when the driver
/// refuses them.
std::unique_ptr<QOpenGLShaderProgram> shader_program(const QByteArray& vertex,
                                                     const QByteArray& fragment);

/// Throws a GraphicsFault when OpenGL has noted an error since it was last asked.
void expect_no_error(QOpenGLExtraFunctions& gl);

}  // namespace pastoso::graphics

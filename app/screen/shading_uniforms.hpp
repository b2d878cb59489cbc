// Hands a scene to the canvas's shader.
#pragma once

#include "screen/scene.hpp"

#include <QOpenGLShaderProgram>

namespace pastoso::screen {

/// How fragments sample the surface.
struct Sampling {
    int pixel_size = 1;        ///< side of a fragment, device pixels
    int samples_per_side = 1;  ///< of a fragment
};

/// `program` is bound.
void set_shading_uniforms(QOpenGLShaderProgram& program, const Scene& scene, const Sampling& sampling);

}  // namespace pastoso::screen

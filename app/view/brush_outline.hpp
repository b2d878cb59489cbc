// The outline of the brush's tip around the pointer: dark and light lines, seen on any paint.
#pragma once

#include <memory>
#include <vector>

#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QSize>
#include <glm/vec2.hpp>

namespace pastoso::view {

/// The tip's footprint on the canvas: an ellipse, or a rectangle with round corners.
struct TipShape {
    double width_mm = 20.0;
    double thickness_mm = 5.0;
    double rotation_deg = 0.0;  ///< of the width's direction, clockwise on the canvas
    bool angular = true;
    friend bool operator==(const TipShape&, const TipShape&) = default;
};

/// A closed line around the shape, relative to its centre.
std::vector<glm::vec2> outline_mm(const TipShape& shape);

/// All calls need the current context that initialise() was called in.
class BrushOutline {
  public:
    void initialise(QOpenGLExtraFunctions* gl);
    void release();

    /// Draws into the bound framebuffer of that size; `centre_px` in device pixels, y down.
    void draw(const TipShape& shape, const glm::dvec2& centre_px, double px_per_mm, QSize window_px);

  private:
    QOpenGLExtraFunctions* gl_ = nullptr;
    std::unique_ptr<QOpenGLShaderProgram> program_;
    GLuint vertex_array_ = 0;
    GLuint vertices_ = 0;
};

}  // namespace pastoso::view

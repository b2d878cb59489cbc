// Lines over the picture: dark and light ones side by side, seen on any paint.
#pragma once

#include <memory>
#include <vector>

#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QSize>
#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

namespace pastoso::view {

/// Where millimetres lie in the window.
struct OverlayFrame {
    glm::dvec2 origin_px{};  ///< of the millimetres, in device pixels, y down
    glm::dmat2 px_from_mm{1.0};
    QSize window_px;
};

/// All calls need the current context that initialise() was called in.
class LineOverlay {
  public:
    void initialise(QOpenGLExtraFunctions* gl);
    void release();

    /// Draw into the bound framebuffer: a closed line through the points, or a line for every two.
    /// `strength` 1 is an outline that has to be seen, less is fainter.
    void draw_loop(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame, float strength);
    void draw_segments(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame,
                       float strength);

    /// A line for every two points, along the millimetres' axes, dark and light in turn.
    void draw_dashes(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame);

  private:
    void draw(GLenum mode, const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame,
              float strength);
    void prepare(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame);
    void finish();

    QOpenGLExtraFunctions* gl_ = nullptr;
    std::unique_ptr<QOpenGLShaderProgram> program_;
    GLuint vertex_array_ = 0;
    GLuint vertices_ = 0;
};

}  // namespace pastoso::view

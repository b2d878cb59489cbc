// Draws over a picture that OpenGL has drawn.
#pragma once

#include "screen/overlay_painter.hpp"

#include <memory>

#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QWidget>

namespace pastoso::screen {

/// All calls need the current context that initialise() was called in, and draw into the framebuffer
/// that is bound.
class GlOverlay : public OverlayPainter {
  public:
    /// `widget` is the one whose frames are drawn.
    void initialise(QOpenGLExtraFunctions* gl, const QWidget& widget);
    void release();

    void draw_loop(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame,
                   float strength) override;
    void draw_segments(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame,
                       float strength) override;
    void draw_dashes(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame) override;
    void draw(const std::function<void(QPainter&)>& drawing) override;

  private:
    void draw_lines(GLenum mode, const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame,
                    float strength);
    void prepare(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame);
    void finish();

    QOpenGLExtraFunctions* gl_ = nullptr;
    const QWidget* widget_ = nullptr;
    std::unique_ptr<QOpenGLShaderProgram> program_;
    GLuint vertex_array_ = 0;
    GLuint vertices_ = 0;
};

}  // namespace pastoso::screen

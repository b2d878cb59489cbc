#include "screen/gl_overlay.hpp"

#include "graphics/graphics_fault.hpp"
#include "screen/canvas_shader.hpp"
#include "screen/uniform_values.hpp"

#include <QOpenGLPaintDevice>
#include <QPainter>
#include <QVector4D>
#include <glm/geometric.hpp>

namespace pastoso::screen {

void GlOverlay::initialise(QOpenGLExtraFunctions* gl, const QWidget& widget) {
    gl_ = gl;
    widget_ = &widget;
    program_ = graphics::shader_program(kLineVertexShader, kLineFragmentShader);
    gl_->glGenVertexArrays(1, &vertex_array_);
    gl_->glBindVertexArray(vertex_array_);
    gl_->glGenBuffers(1, &vertices_);
    gl_->glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    gl_->glEnableVertexAttribArray(0);
    gl_->glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl_->glBindVertexArray(0);
    gl_->glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void GlOverlay::release() {
    program_.reset();
    if (gl_ == nullptr) return;
    gl_->glDeleteVertexArrays(1, &vertex_array_);
    gl_->glDeleteBuffers(1, &vertices_);
    vertex_array_ = vertices_ = 0;
}

void GlOverlay::draw_loop(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame,
                          float strength) {
    draw_lines(GL_LINE_LOOP, points_mm, frame, strength);
}

void GlOverlay::draw_segments(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame,
                              float strength) {
    draw_lines(GL_LINES, points_mm, frame, strength);
}

void GlOverlay::draw_lines(GLenum mode, const std::vector<glm::vec2>& points_mm,
                           const OverlayFrame& frame, float strength) {
    if (points_mm.empty()) return;
    prepare(points_mm, frame);
    gl_->glEnable(GL_BLEND);
    gl_->glEnable(GL_LINE_SMOOTH);
    // The window stays opaque under the line.
    gl_->glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    program_->setUniformValue("dash_px", 0.0F);
    const auto lines = [&](double shift_px, const QVector4D& colour) {
        program_->setUniformValue("origin_px", vector(frame.origin_px + shift_px));
        program_->setUniformValue("line_colour", colour);
        gl_->glDrawArrays(mode, 0, static_cast<GLsizei>(points_mm.size()));
    };
    lines(1.0, QVector4D(0.0F, 0.0F, 0.0F, 0.55F * strength));
    lines(0.0, QVector4D(1.0F, 1.0F, 1.0F, 0.75F * strength));
    gl_->glDisable(GL_LINE_SMOOTH);
    gl_->glDisable(GL_BLEND);
    finish();
}

void GlOverlay::draw_dashes(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame) {
    constexpr float kDash_px = 4.0F;
    if (points_mm.empty()) return;
    prepare(points_mm, frame);
    program_->setUniformValue("dash_px", kDash_px);
    const glm::dvec2 way = glm::normalize(frame.px_from_mm[0]) + glm::normalize(frame.px_from_mm[1]);
    program_->setUniformValue("dash_way", vector({way.x, -way.y}));
    program_->setUniformValue("origin_px", vector(frame.origin_px));
    program_->setUniformValue("line_colour", QVector4D(1.0F, 1.0F, 1.0F, 1.0F));
    gl_->glDrawArrays(GL_LINES, 0, static_cast<GLsizei>(points_mm.size()));
    finish();
}

/// Not on the widget: while that is grabbed as a part of its window, a painter on it draws into what is
/// grabbed, and the frame comes over it.
void GlOverlay::draw(const std::function<void(QPainter&)>& drawing) {
    QOpenGLPaintDevice frame(widget_->size() * widget_->devicePixelRatioF());
    frame.setDevicePixelRatio(widget_->devicePixelRatioF());
    QPainter painter(&frame);
    drawing(painter);
}

void GlOverlay::prepare(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame) {
    const QSize size = frame.window_px;
    gl_->glViewport(0, 0, size.width(), size.height());
    program_->bind();
    program_->setUniformValue("window_px", vector({size.width(), size.height()}));
    program_->setUniformValue("px_from_mm", matrix(frame.px_from_mm));
    gl_->glBindVertexArray(vertex_array_);
    gl_->glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    gl_->glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(points_mm.size() * sizeof(glm::vec2)),
                      points_mm.data(), GL_STREAM_DRAW);
}

void GlOverlay::finish() {
    gl_->glBindBuffer(GL_ARRAY_BUFFER, 0);
    gl_->glBindVertexArray(0);
    program_->release();
}

}  // namespace pastoso::screen

#include "view/brush_outline.hpp"

#include "core/check.hpp"
#include "core/units.hpp"
#include "view/canvas_shader.hpp"

#include <algorithm>
#include <cmath>

#include <QVector2D>
#include <QVector4D>

namespace pastoso::view {
namespace {

constexpr int kPoints = 96;

/// Exponent of the superellipse: 2 is an ellipse, 6 a rectangle with round corners.
constexpr double kRound = 2.0;
constexpr double kAngular = 6.0;

double signed_power(double value, double exponent) {
    return std::copysign(std::pow(std::abs(value), exponent), value);
}

}  // namespace

std::vector<glm::vec2> outline_mm(const TipShape& shape) {
    const double exponent = 2.0 / (shape.angular ? kAngular : kRound);
    const double turn = core::radians(shape.rotation_deg);
    std::vector<glm::vec2> points;
    points.reserve(kPoints);
    for (int i = 0; i < kPoints; ++i) {
        const double angle = 2.0 * core::kPi * i / kPoints;
        const double x = 0.5 * shape.width_mm * signed_power(std::cos(angle), exponent);
        const double y = 0.5 * shape.thickness_mm * signed_power(std::sin(angle), exponent);
        points.emplace_back(x * std::cos(turn) - y * std::sin(turn),
                            x * std::sin(turn) + y * std::cos(turn));
    }
    return points;
}

void BrushOutline::initialise(QOpenGLExtraFunctions* gl) {
    gl_ = gl;
    program_ = std::make_unique<QOpenGLShaderProgram>();
    program_->addShaderFromSourceCode(QOpenGLShader::Vertex, kOutlineVertexShader);
    program_->addShaderFromSourceCode(QOpenGLShader::Fragment, kOutlineFragmentShader);
    PASTOSO_CHECK(program_->link());
    gl_->glGenVertexArrays(1, &vertex_array_);
    gl_->glBindVertexArray(vertex_array_);
    gl_->glGenBuffers(1, &vertices_);
    gl_->glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    gl_->glBufferData(GL_ARRAY_BUFFER, kPoints * sizeof(glm::vec2), nullptr, GL_STREAM_DRAW);
    gl_->glEnableVertexAttribArray(0);
    gl_->glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl_->glBindVertexArray(0);
    gl_->glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void BrushOutline::release() {
    program_.reset();
    if (gl_ == nullptr) return;
    gl_->glDeleteVertexArrays(1, &vertex_array_);
    gl_->glDeleteBuffers(1, &vertices_);
    vertex_array_ = vertices_ = 0;
}

void BrushOutline::draw(const TipShape& shape, const glm::dvec2& centre_px, double px_per_mm,
                        QSize window_px) {
    const std::vector<glm::vec2> points = outline_mm(shape);
    gl_->glViewport(0, 0, window_px.width(), window_px.height());
    gl_->glEnable(GL_BLEND);
    gl_->glEnable(GL_LINE_SMOOTH);
    // The window stays opaque under the line.
    gl_->glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    program_->bind();
    program_->setUniformValue("window_px", QVector2D(window_px.width(), window_px.height()));
    program_->setUniformValue("px_per_mm", static_cast<float>(px_per_mm));
    gl_->glBindVertexArray(vertex_array_);
    gl_->glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    gl_->glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(points.size() * sizeof(glm::vec2)),
                         points.data());
    const auto loop = [&](double shift_px, const QVector4D& colour) {
        program_->setUniformValue("centre_px", QVector2D(static_cast<float>(centre_px.x + shift_px),
                                                         static_cast<float>(centre_px.y + shift_px)));
        program_->setUniformValue("line_colour", colour);
        gl_->glDrawArrays(GL_LINE_LOOP, 0, kPoints);
    };
    loop(1.0, QVector4D(0.0F, 0.0F, 0.0F, 0.55F));
    loop(0.0, QVector4D(1.0F, 1.0F, 1.0F, 0.75F));
    gl_->glBindBuffer(GL_ARRAY_BUFFER, 0);
    gl_->glBindVertexArray(0);
    program_->release();
    gl_->glDisable(GL_LINE_SMOOTH);
    gl_->glDisable(GL_BLEND);
}

}  // namespace pastoso::view

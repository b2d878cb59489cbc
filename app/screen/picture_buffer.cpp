#include "screen/picture_buffer.hpp"

#include "graphics/finish_shader.hpp"
#include "graphics/graphics_fault.hpp"
#include "screen/canvas_shader.hpp"
#include "screen/shading_uniforms.hpp"
#include "screen/uniform_values.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <QVector3D>

namespace pastoso::screen {
namespace {

constexpr int kSurfaceUnit = 0;
constexpr int kColourUnit = 1;
constexpr int kLookUnit = 2;
constexpr int kOutlineUnit = 3;
constexpr int kDryUnit = 4;
constexpr int kCoarsePixel = 2;

/// To be shaded into.
std::unique_ptr<QOpenGLFramebufferObject> new_picture(QSize size) {
    return std::make_unique<QOpenGLFramebufferObject>(size, QOpenGLFramebufferObject::NoAttachment,
                                                      GL_TEXTURE_2D, GL_RGBA16);
}

QRect whole(QSize size) {
    return {QPoint(0, 0), size};
}

QSize coarse_size(QSize size) {
    return {(size.width() + kCoarsePixel - 1) / kCoarsePixel,
            (size.height() + kCoarsePixel - 1) / kCoarsePixel};
}

/// The coarse pixels that `part` touches and one around them, which the enlargement blends in.
QRect coarse_part(const QRect& part, QSize window) {
    const QPoint first = part.topLeft() / kCoarsePixel - QPoint(1, 1);
    const QPoint last = part.bottomRight() / kCoarsePixel + QPoint(1, 1);
    return QRect(first, last).intersected(whole(coarse_size(window)));
}

void set_scissor(QOpenGLExtraFunctions& gl, const QRect& part) {
    gl.glEnable(GL_SCISSOR_TEST);
    gl.glScissor(part.x(), part.y(), part.width(), part.height());
}

}  // namespace

void PictureBuffer::initialise(QOpenGLExtraFunctions* gl) {
    gl_ = gl;
    prepare(Look::Lit);
    squint_.initialise(gl);
    finish_.initialise(gl);
    gl_->glGenVertexArrays(1, &vertex_array_);
}

void PictureBuffer::prepare(Look look) {
    program_of({look, false});
    if (has_outlines(look)) program_of({look, true});
}

QOpenGLShaderProgram& PictureBuffer::program_of(const ProgramKind& kind) {
    std::unique_ptr<QOpenGLShaderProgram>& program = programs_[kind];
    if (program == nullptr) {
        program = graphics::shader_program(graphics::kCoveringVertexShader,
                                           canvas_fragment_shader(kind.first, kind.second).c_str());
    }
    return *program;
}

void PictureBuffer::release() {
    programs_.clear();
    move_program_.reset();
    picture_.reset();
    spare_.reset();
    coarse_.reset();
    squint_.release();
    finish_.release();
    size_ = {};
    if (gl_ != nullptr) gl_->glDeleteVertexArrays(1, &vertex_array_);
    vertex_array_ = 0;
}

void PictureBuffer::resize(QSize window_px, const Rgb& ground) {
    if (picture_ != nullptr && window_px == size_) return;
    size_ = window_px;
    picture_ = new_picture(size_);
    coarse_ = new_picture(coarse_size(size_));
    spare_.reset();
    picture_->bind();
    gl_->glClearColor(ground[0], ground[1], ground[2], 0.0F);
    gl_->glClear(GL_COLOR_BUFFER_BIT);
}

void PictureBuffer::move(const ViewTransform& from, const ViewTransform& to, const Rgb& ground) {
    if (move_program_ == nullptr)
        move_program_ = graphics::shader_program(graphics::kCoveringVertexShader, kMovedFragmentShader);
    if (spare_ == nullptr) spare_ = new_picture(size_);
    const glm::dvec2 origin = moved_px(to, from, {0.0, 0.0});
    const glm::dmat2 per_px{moved_px(to, from, {1.0, 0.0}) - origin,
                            moved_px(to, from, {0.0, 1.0}) - origin};
    spare_->bind();
    gl_->glViewport(0, 0, size_.width(), size_.height());
    gl_->glDisable(GL_BLEND);
    gl_->glDisable(GL_DEPTH_TEST);
    gl_->glActiveTexture(GL_TEXTURE0);
    gl_->glBindTexture(GL_TEXTURE_2D, picture_->texture());
    // Between pixels that come to lie on pixels nothing must be mixed, however little.
    const GLint filter = whole_pixels_between(from, to) ? GL_NEAREST : GL_LINEAR;
    gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    move_program_->bind();
    move_program_->setUniformValue("picture", 0);
    move_program_->setUniformValue("size_px", vector({size_.width(), size_.height()}));
    move_program_->setUniformValue("origin_px", vector(origin));
    move_program_->setUniformValue("per_px", matrix(per_px));
    move_program_->setUniformValue("ground", QVector3D(ground[0], ground[1], ground[2]));
    gl_->glBindVertexArray(vertex_array_);
    gl_->glDrawArrays(GL_TRIANGLES, 0, 3);
    gl_->glBindVertexArray(0);
    move_program_->release();
    std::swap(picture_, spare_);
}

void PictureBuffer::shade(const QRect& part, Quality quality, const Scene& scene) {
    const QRegion outlines = has_outlines(scene.look) ? scene.outlines & part : QRegion();
    if (quality == Quality::Coarse) {
        const QRect coarse = coarse_part(part, size_);
        QRegion coarse_outlines;
        for (const QRect& rect : outlines)
            coarse_outlines += coarse_part(rect, size_);
        draw(QRegion(coarse) - coarse_outlines, *coarse_, {kCoarsePixel, 1}, scene, false);
        draw(coarse_outlines, *coarse_, {kCoarsePixel, 1}, scene, true);
        enlarge_coarse(coarse, part);
    } else {
        const Sampling sampling{1, samples_per_side(quality, scene.view.zoom)};
        draw(QRegion(part) - outlines, *picture_, sampling, scene, false);
        draw(outlines, *picture_, sampling, scene, true);
    }
}

void PictureBuffer::draw(const QRegion& parts, QOpenGLFramebufferObject& target,
                         const Sampling& sampling, const Scene& scene, bool outlined) {
    if (parts.isEmpty()) return;
    target.bind();
    gl_->glViewport(0, 0, target.width(), target.height());
    gl_->glDisable(GL_BLEND);
    gl_->glDisable(GL_DEPTH_TEST);
    QOpenGLShaderProgram& program = program_of({scene.look, outlined});
    program.bind();
    scene.canvas->bind(kSurfaceUnit, kColourUnit, kLookUnit);
    program.setUniformValue("surface_layers", kSurfaceUnit);
    program.setUniformValue("colour_and_wetness", kColourUnit);
    program.setUniformValue("look_thickness", kLookUnit);
    if (outlined) {
        scene.canvas->bind_outline(kOutlineUnit, kDryUnit);
        program.setUniformValue("outline_layers", kOutlineUnit);
        program.setUniformValue("dry_colours", kDryUnit);
    }
    set_shading_uniforms(program, scene, sampling);
    gl_->glBindVertexArray(vertex_array_);
    for (const QRect& part : parts) {
        set_scissor(*gl_, part);
        gl_->glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    gl_->glBindVertexArray(0);
    program.release();
    gl_->glDisable(GL_SCISSOR_TEST);
}

void PictureBuffer::enlarge_coarse(const QRect& coarse, const QRect& part) {
    gl_->glBindFramebuffer(GL_READ_FRAMEBUFFER, coarse_->handle());
    gl_->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, picture_->handle());
    set_scissor(*gl_, part);
    const int x0 = coarse.x();
    const int y0 = coarse.y();
    const int x1 = x0 + coarse.width();
    const int y1 = y0 + coarse.height();
    gl_->glBlitFramebuffer(x0, y0, x1, y1, kCoarsePixel * x0, kCoarsePixel * y0, kCoarsePixel * x1,
                           kCoarsePixel * y1, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    gl_->glDisable(GL_SCISSOR_TEST);
}

void PictureBuffer::finish(const appearance::ScreenCube& cube, double squint_px, GLuint framebuffer) {
    const GLuint picture =
        squint_px > 0.0 ? squint_.squinted(picture_->texture(), size_, squint_px) : picture_->texture();
    finish_.draw(picture, size_, cube, framebuffer);
}

}  // namespace pastoso::screen

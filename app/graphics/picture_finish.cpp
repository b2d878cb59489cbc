#include "graphics/picture_finish.hpp"

#include "graphics/finish_shader.hpp"
#include "graphics/graphics_fault.hpp"

#include <QVector3D>

namespace pastoso::graphics {
namespace {

using pigment::ColourCube;

constexpr int kPictureUnit = 0, kCubeUnit = 1;

// What is uploaded.
static_assert(sizeof(ColourCube::Node) == 4 * sizeof(float));

/// Of the framebuffer that is bound, less one.
float levels_of(QOpenGLExtraFunctions& gl, GLuint framebuffer) {
    GLint bits = 0;
    gl.glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER,
                                             framebuffer == 0 ? GL_BACK_LEFT : GL_COLOR_ATTACHMENT0,
                                             GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, &bits);
    return bits == 10 ? 1023.0F : 255.0F;
}

}  // namespace

void PictureFinish::initialise(QOpenGLExtraFunctions* gl) {
    gl_ = gl;
    program_ = shader_program(kCoveringVertexShader, kFinishShader);
    gl_->glGenVertexArrays(1, &vertex_array_);
    gl_->glGenTextures(1, &cube_);
}

void PictureFinish::release() {
    program_.reset();
    uploaded_.reset();
    if (gl_ == nullptr) return;
    gl_->glDeleteVertexArrays(1, &vertex_array_);
    gl_->glDeleteTextures(1, &cube_);
    vertex_array_ = cube_ = 0;
}

void PictureFinish::upload(const appearance::ScreenCube& cube) {
    gl_->glActiveTexture(GL_TEXTURE0 + kCubeUnit);
    gl_->glBindTexture(GL_TEXTURE_3D, cube_);
    if (cube == nullptr || cube == uploaded_) return;
    constexpr int kSide = ColourCube::kSide;
    gl_->glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA32F, kSide, kSide, kSide, 0, GL_RGBA, GL_FLOAT,
                      cube->nodes.data());
    gl_->glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_->glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl_->glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
    uploaded_ = cube;
}

void PictureFinish::draw(GLuint picture, const QSize& size, const appearance::ScreenCube& cube,
                         GLuint framebuffer) {
    gl_->glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl_->glViewport(0, 0, size.width(), size.height());
    gl_->glDisable(GL_BLEND);
    gl_->glDisable(GL_DEPTH_TEST);
    upload(cube);
    gl_->glActiveTexture(GL_TEXTURE0 + kPictureUnit);
    gl_->glBindTexture(GL_TEXTURE_2D, picture);
    program_->bind();
    program_->setUniformValue("picture", kPictureUnit);
    program_->setUniformValue("cube", kCubeUnit);
    program_->setUniformValue("cube_last", cube == nullptr ? 0 : ColourCube::kSide - 1);
    const pigment::EncodedRgb& mark = pigment::kGamutMark;
    program_->setUniformValue("gamut_mark", QVector3D(mark[0], mark[1], mark[2]));
    program_->setUniformValue("window_height", size.height());
    program_->setUniformValue("levels", levels_of(*gl_, framebuffer));
    gl_->glBindVertexArray(vertex_array_);
    gl_->glDrawArrays(GL_TRIANGLES, 0, 3);
    gl_->glBindVertexArray(0);
    program_->release();
}

}  // namespace pastoso::graphics

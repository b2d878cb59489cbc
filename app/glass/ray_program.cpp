#include "glass/ray_program.hpp"

#include "glass/ray_shaders.hpp"

#include <cmath>

#include <QVector2D>
#include <glm/geometric.hpp>

namespace pastoso::glass {
namespace {

/// Parts of a golden ratio fill an interval evenly, however many there are.
float spread(int pass, double ratio) {
    return static_cast<float>(std::fmod(0.5 + ratio * pass, 1.0));
}

}  // namespace

QVector3D vector(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}

QMatrix4x4 matrix(const glm::mat4& m) {
    QMatrix4x4 result;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            result(row, column) = m[column][row];
    return result;
}

std::unique_ptr<QOpenGLShaderProgram> ray_program(const QByteArray& words) {
    return graphics::shader_program(kRayVertexShader, QByteArray(kLightShader) + words + kMainShader);
}

void set_rays(QOpenGLShaderProgram& program, const GlassCamera& camera, QSize size, int pass) {
    const float aspect = static_cast<float>(size.width()) / static_cast<float>(size.height());
    program.setUniformValue("eye_m", vector(camera.eye_m()));
    program.setUniformValue("forward", vector(camera.forward()));
    program.setUniformValue("right", vector(camera.right() * (camera.half_height() * aspect)));
    program.setUniformValue("up", vector(camera.up() * camera.half_height()));
    const QVector2D shift((spread(pass, 0.7548776662) - 0.5F) / static_cast<float>(size.width()),
                          (spread(pass, 0.5698402910) - 0.5F) / static_cast<float>(size.height()));
    program.setUniformValue("shift", shift);
    program.setUniformValue("grain", spread(pass, 0.6180339887));
}

void draw_rays(QOpenGLExtraFunctions& gl, QOpenGLFramebufferObject& target, const QRect& part, int pass,
               GLuint empty_array) {
    target.bind();
    gl.glViewport(0, 0, target.width(), target.height());
    gl.glEnable(GL_SCISSOR_TEST);
    gl.glScissor(part.x(), part.y(), part.width(), part.height());
    gl.glDisable(GL_DEPTH_TEST);
    gl.glEnable(GL_BLEND);
    gl.glBlendColor(0.0F, 0.0F, 0.0F, 1.0F / static_cast<float>(pass + 1));
    gl.glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    if (pass == 0) gl.glDisable(GL_BLEND);
    gl.glBindVertexArray(empty_array);
    gl.glDrawArrays(GL_TRIANGLES, 0, 3);
    gl.glBindVertexArray(0);
    gl.glDisable(GL_BLEND);
    gl.glDisable(GL_SCISSOR_TEST);
}

Volume volume_of(const grid::BoxField& field) {
    const grid::BoxShape& shape = field.shape();
    return {field.row(0, 0), shape.nx, shape.ny, shape.nz, shape.stride_y(), shape.stride_z()};
}

void set_interpolation(QOpenGLExtraFunctions& gl) {
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        gl.glTexParameteri(GL_TEXTURE_3D, filter, GL_LINEAR);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        gl.glTexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
    gl.glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
}

void upload_volume(QOpenGLExtraFunctions& gl, GLuint texture, const Volume& volume, bool anew) {
    gl.glBindTexture(GL_TEXTURE_3D, texture);
    gl.glPixelStorei(GL_UNPACK_ROW_LENGTH, static_cast<GLint>(volume.stride_y));
    gl.glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, static_cast<GLint>(volume.stride_z / volume.stride_y));
    if (anew) {
        gl.glTexImage3D(GL_TEXTURE_3D, 0, GL_R16F, volume.nx, volume.ny, volume.nz, 0, GL_RED, GL_FLOAT,
                        volume.values);
        set_interpolation(gl);
    } else {
        gl.glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, volume.nx, volume.ny, volume.nz, GL_RED, GL_FLOAT,
                           volume.values);
    }
    gl.glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    gl.glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, 0);
}

}  // namespace pastoso::glass

// What the programs need that follow a ray for each pixel.
#pragma once

#include "glass/glass_camera.hpp"
#include "graphics/graphics_fault.hpp"
#include "grid/box_field.hpp"

#include <memory>

#include <QByteArray>
#include <QMatrix4x4>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>
#include <QOpenGLShaderProgram>
#include <QRect>
#include <QVector3D>

namespace pastoso::glass {

/// A draft is coarser in what takes long.
enum class Quality { Draft, Full };

QVector3D vector(const glm::vec3& v);
QMatrix4x4 matrix(const glm::mat4& m);

/// `words` between those that all such programs share (kLightShader, kMainShader). Throws
/// graphics::GraphicsFault when the driver refuses it.
std::unique_ptr<QOpenGLShaderProgram> ray_program(const QByteArray& words);

/// The camera of the `pass`-th picture of several, whose samples lie elsewhere within a pixel.
void set_rays(QOpenGLShaderProgram& program, const GlassCamera& camera, QSize size, int pass);

/// Draws the rows of `part` (counted from below) into `target`, which keeps the mean of all passes. The
/// program and its textures are bound; `empty_array` has no attributes.
void draw_rays(QOpenGLExtraFunctions& gl, QOpenGLFramebufferObject& target, const QRect& part, int pass,
               GLuint empty_array);

/// Of the bound volume: linear between its points, and beyond them as at its edge.
void set_interpolation(QOpenGLExtraFunctions& gl);

/// Numbers at the points of a box as a texture of halves, x fastest, with rows in memory that are
/// `stride_y` long. Allocates it anew when `anew`.
struct Volume {
    const float* values;
    int nx, ny, nz;
    std::ptrdiff_t stride_y, stride_z;
};
/// The cells of a field, straight from its rows, which are longer than the box.
Volume volume_of(const grid::BoxField& field);
void upload_volume(QOpenGLExtraFunctions& gl, GLuint texture, const Volume& volume, bool anew);

}  // namespace pastoso::glass

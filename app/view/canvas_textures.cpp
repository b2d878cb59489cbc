#include "view/canvas_textures.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <string>

namespace pastoso::view {

void CanvasTextures::initialise(QOpenGLExtraFunctions* gl, grid::Shape shape) {
    gl_ = gl;
    GLint largest = 0;
    gl_->glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (std::max(shape.width, shape.height) + 2 * kLayerBorder > largest) {
        throw core::InputError("The canvas is " + std::to_string(shape.width) + " x " +
                               std::to_string(shape.height) + " cells, more than the " +
                               std::to_string(largest) + " a side that this graphics driver can show.");
    }
    release();
    shape_ = shape;
    surface_ = make_texture(GL_RGB32F, GL_RGB);
    colour_ = make_texture(GL_RGBA16F, GL_RGBA);
}

void CanvasTextures::release() {
    if (gl_ == nullptr) return;
    gl_->glDeleteTextures(1, &surface_);
    gl_->glDeleteTextures(1, &colour_);
    gl_->glDeleteTextures(1, &look_);
    surface_ = colour_ = look_ = 0;
}

GLuint CanvasTextures::make_texture(GLenum internal_format, GLenum format) {
    GLuint texture = 0;
    gl_->glGenTextures(1, &texture);
    gl_->glBindTexture(GL_TEXTURE_2D, texture);
    gl_->glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal_format),
                      shape_.width + 2 * kLayerBorder, shape_.height + 2 * kLayerBorder, 0, format,
                      GL_FLOAT, nullptr);
    gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    return texture;
}

void CanvasTextures::upload_surface(const CanvasLayers& layers, const QRegion& cells) {
    gl_->glBindTexture(GL_TEXTURE_2D, surface_);
    gl_->glPixelStorei(GL_UNPACK_ROW_LENGTH, layers.stride());
    for (const QRect& part : cells) {
        gl_->glTexSubImage2D(GL_TEXTURE_2D, 0, part.x() + kLayerBorder, part.y() + kLayerBorder,
                             part.width(), part.height(), GL_RGB, GL_FLOAT,
                             layers.surface(part.x(), part.y()));
    }
    gl_->glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void CanvasTextures::upload_colours(const std::vector<ColourPatch>& patches) {
    gl_->glBindTexture(GL_TEXTURE_2D, colour_);
    for (const ColourPatch& patch : patches) {
        gl_->glTexSubImage2D(GL_TEXTURE_2D, 0, patch.cells.x0 + kLayerBorder,
                             patch.cells.y0 + kLayerBorder, patch.cells.width(), patch.cells.height(),
                             GL_RGBA, GL_FLOAT, patch.colours.data());
    }
}

void CanvasTextures::upload_look(const std::vector<LookPatch>& patches) {
    if (look_ == 0) look_ = make_texture(GL_R32F, GL_RED);
    gl_->glBindTexture(GL_TEXTURE_2D, look_);
    for (const LookPatch& patch : patches) {
        gl_->glTexSubImage2D(GL_TEXTURE_2D, 0, patch.cells.x0 + kLayerBorder,
                             patch.cells.y0 + kLayerBorder, patch.cells.width(), patch.cells.height(),
                             GL_RED, GL_FLOAT, patch.thickness_mm.data());
    }
}

void CanvasTextures::bind(int surface_unit, int colour_unit, int look_unit) {
    gl_->glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(surface_unit));
    gl_->glBindTexture(GL_TEXTURE_2D, surface_);
    gl_->glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(colour_unit));
    gl_->glBindTexture(GL_TEXTURE_2D, colour_);
    gl_->glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(look_unit));
    gl_->glBindTexture(GL_TEXTURE_2D, look_);
    gl_->glActiveTexture(GL_TEXTURE0);
}

}  // namespace pastoso::view

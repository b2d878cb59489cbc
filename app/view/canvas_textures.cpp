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
    gl_->glDeleteTextures(1, &outline_);
    gl_->glDeleteTextures(1, &dry_);
    surface_ = colour_ = look_ = outline_ = dry_ = 0;
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

void CanvasTextures::put(GLuint texture, const grid::Rect& cells, GLenum format, const void* values) {
    gl_->glBindTexture(GL_TEXTURE_2D, texture);
    gl_->glTexSubImage2D(GL_TEXTURE_2D, 0, cells.x0 + kLayerBorder, cells.y0 + kLayerBorder,
                         cells.width(), cells.height(), format, GL_FLOAT, values);
}

void CanvasTextures::upload_surface(const SurfacePatch& patch) {
    put(surface_, patch.cells, GL_RGB, patch.texels.data());
}

void CanvasTextures::upload_colour(const ColourPatch& patch) {
    put(colour_, patch.cells, GL_RGBA, patch.colours.data());
}

void CanvasTextures::upload_look(const LookPatch& patch) {
    if (look_ == 0) look_ = make_texture(GL_R32F, GL_RED);
    put(look_, patch.cells, GL_RED, patch.thickness_mm.data());
}

void CanvasTextures::upload_outlines(const std::vector<OutlinePatch>& patches) {
    if (outline_ == 0) outline_ = make_texture(GL_RGBA32F, GL_RGBA);
    if (dry_ == 0) dry_ = make_texture(GL_RGBA16F, GL_RGBA);
    for (const OutlinePatch& patch : patches) {
        put(outline_, patch.cells, GL_RGBA, patch.outline.data());
        put(dry_, patch.cells, GL_RGBA, patch.dry.data());
    }
}

void CanvasTextures::bind_to(int unit, GLuint texture) {
    gl_->glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl_->glBindTexture(GL_TEXTURE_2D, texture);
    gl_->glActiveTexture(GL_TEXTURE0);
}

void CanvasTextures::bind(int surface_unit, int colour_unit, int look_unit) {
    bind_to(surface_unit, surface_);
    bind_to(colour_unit, colour_);
    bind_to(look_unit, look_);
}

void CanvasTextures::bind_outline(int outline_unit, int dry_unit) {
    bind_to(outline_unit, outline_);
    bind_to(dry_unit, dry_);
}

}  // namespace pastoso::view

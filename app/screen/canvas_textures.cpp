#include "screen/canvas_textures.hpp"

#include "graphics/graphics_fault.hpp"

#include <string>

namespace pastoso::screen {
namespace {

int number(QOpenGLExtraFunctions& gl, GLenum what) {
    GLint value = 0;
    gl.glGetIntegerv(what, &value);
    return value;
}

}  // namespace

void CanvasTextures::initialise(QOpenGLExtraFunctions* gl, grid::Shape shape) {
    gl_ = gl;
    release();
    shape_ = shape;
    pages_ = page_layout(shape, number(*gl_, GL_MAX_TEXTURE_SIZE));
    if (pages_.count() > number(*gl_, GL_MAX_ARRAY_TEXTURE_LAYERS)) {
        throw graphics::GraphicsFault(
            "The canvas is %1 x %2 pixels, more than this graphics driver can show.", shape.width,
            shape.height);
    }
    surface_ = make_texture(GL_RGB32F, kThree);
    colour_ = make_texture(GL_RGBA16F, kFour);
    graphics::expect_no_error(*gl_);
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

GLuint CanvasTextures::make_texture(GLenum internal_format, const Texels& texels) {
    GLuint texture = 0;
    gl_->glGenTextures(1, &texture);
    gl_->glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    gl_->glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, static_cast<GLint>(internal_format),
                      pages_.width + 2 * kLayerBorder, pages_.height + 2 * kLayerBorder, pages_.count(),
                      0, texels.format, GL_FLOAT, nullptr);
    gl_->glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_->glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl_->glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
    return texture;
}

/// Cells at the edge of a page lie in the border of the next one, too.
void CanvasTextures::put(GLuint texture, const grid::Rect& cells, const Texels& texels,
                         const void* values) {
    gl_->glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    gl_->glPixelStorei(GL_UNPACK_ROW_LENGTH, cells.width());
    for (const int page : pages_.pages_of(cells)) {
        const grid::Rect held = pages_.cells(page);
        const grid::Rect part = grid::intersection(held, cells);
        const std::ptrdiff_t first =
            static_cast<std::ptrdiff_t>(part.y0 - cells.y0) * cells.width() + (part.x0 - cells.x0);
        gl_->glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, part.x0 - held.x0, part.y0 - held.y0, page,
                             part.width(), part.height(), 1, texels.format, GL_FLOAT,
                             static_cast<const float*>(values) + texels.floats * first);
    }
    gl_->glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void CanvasTextures::upload_surface(const SurfacePatch& patch) {
    put(surface_, patch.cells, kThree, patch.texels.data());
}

void CanvasTextures::upload_colour(const ColourPatch& patch) {
    put(colour_, patch.cells, kFour, patch.colours.data());
}

void CanvasTextures::upload_look(const LookPatch& patch) {
    if (look_ == 0) look_ = make_texture(GL_R32F, kOne);
    put(look_, patch.cells, kOne, patch.thickness_mm.data());
}

void CanvasTextures::upload_outlines(const OutlinePatch& patch) {
    if (outline_ == 0) outline_ = make_texture(GL_RGBA32F, kFour);
    if (dry_ == 0) dry_ = make_texture(GL_RGBA16F, kFour);
    put(outline_, patch.cells, kFour, patch.outline.data());
    put(dry_, patch.cells, kFour, patch.dry.data());
}

void CanvasTextures::bind_to(int unit, GLuint texture) {
    gl_->glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl_->glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
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

}  // namespace pastoso::screen

// The canvas's layers on the graphics card, one texel per cell and a border.
#pragma once

#include "grid/shape.hpp"
#include "view/canvas_layers.hpp"
#include "view/canvas_outlines.hpp"
#include "view/look_layer.hpp"

#include <QOpenGLExtraFunctions>

namespace pastoso::view {

/// All calls need the current context that initialise() was called in.
class CanvasTextures {
  public:
    /// Throws core::InputError when the card cannot hold textures of this size.
    void initialise(QOpenGLExtraFunctions* gl, grid::Shape shape);
    void release();

    void upload_surface(const SurfacePatch& patch);
    void upload_colour(const ColourPatch& patch);
    /// What a look shows; the texture for it is made when it is first wanted.
    void upload_look(const LookPatch& patch);
    /// What outlines are drawn from; the textures for it are made when they are first wanted.
    void upload_outlines(const std::vector<OutlinePatch>& patches);
    void bind(int surface_unit, int colour_unit, int look_unit);
    void bind_outline(int outline_unit, int dry_unit);

    const grid::Shape& shape() const { return shape_; }

  private:
    void bind_to(int unit, GLuint texture);
    GLuint make_texture(GLenum internal_format, GLenum format);
    void put(GLuint texture, const grid::Rect& cells, GLenum format, const void* values);

    QOpenGLExtraFunctions* gl_ = nullptr;
    grid::Shape shape_;
    GLuint surface_ = 0;
    GLuint colour_ = 0;
    GLuint look_ = 0;
    GLuint outline_ = 0;
    GLuint dry_ = 0;
};

}  // namespace pastoso::view

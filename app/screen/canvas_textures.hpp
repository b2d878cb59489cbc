// The canvas's layers on the graphics card, one texel per cell and a border. A canvas larger than the
// card's largest texture lies in several pages.
#pragma once

#include "grid/shape.hpp"
#include "screen/canvas_layers.hpp"
#include "screen/canvas_outlines.hpp"
#include "screen/look_layer.hpp"
#include "screen/page_layout.hpp"

#include <QOpenGLExtraFunctions>

namespace pastoso::screen {

/// All calls need the current context that initialise() was called in.
class CanvasTextures {
  public:
    /// Throws graphics::GraphicsFault when the card cannot hold them.
    void initialise(QOpenGLExtraFunctions* gl, grid::Shape shape);
    void release();

    void upload_surface(const SurfacePatch& patch);
    void upload_colour(const ColourPatch& patch);
    /// What a look shows; the texture for it is made when it is first wanted.
    void upload_look(const LookPatch& patch);
    /// What outlines are drawn from; the textures for it are made when they are first wanted.
    void upload_outlines(const OutlinePatch& patch);
    void bind(int surface_unit, int colour_unit, int look_unit);
    void bind_outline(int outline_unit, int dry_unit);

    const grid::Shape& shape() const { return shape_; }
    const PageLayout& pages() const { return pages_; }

  private:
    /// How texels lie in memory.
    struct Texels {
        GLenum format;
        int floats;  ///< of a texel
    };

    void bind_to(int unit, GLuint texture);
    GLuint make_texture(GLenum internal_format, const Texels& texels);
    void put(GLuint texture, const grid::Rect& cells, const Texels& texels, const void* values);

    static constexpr Texels kOne{GL_RED, 1}, kThree{GL_RGB, 3}, kFour{GL_RGBA, 4};

    QOpenGLExtraFunctions* gl_ = nullptr;
    grid::Shape shape_;
    PageLayout pages_;
    GLuint surface_ = 0;
    GLuint colour_ = 0;
    GLuint look_ = 0;
    GLuint outline_ = 0;
    GLuint dry_ = 0;
};

}  // namespace pastoso::screen

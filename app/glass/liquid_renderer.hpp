// What draws a liquid with OpenGL 3.3.
#pragma once

#include "glass/ray_program.hpp"

namespace pastoso::glass {

/// All calls need the current context that initialise() was called in.
class LiquidRenderer {
  public:
    virtual ~LiquidRenderer() = default;

    /// Throws core::InputError when the driver refuses a program.
    virtual void initialise(QOpenGLExtraFunctions* gl) = 0;
    virtual void release() = 0;

    /// Draws the rows of `part` (counted from below) of a picture into `target`, as the `pass`-th of
    /// several that are blended to their mean.
    virtual void draw(QOpenGLFramebufferObject& target, const QRect& part, const GlassCamera& camera,
                      int pass, Quality quality) = 0;
};

}  // namespace pastoso::glass

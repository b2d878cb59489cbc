// Where the brush is over a canvas, for those who do not see it.
#pragma once

#include "view/canvas_view.hpp"

namespace pastoso::main {

/// From now on the view says it, as what a screen reader reads of a canvas.
void say_pointer(view::CanvasView& view);

}  // namespace pastoso::main

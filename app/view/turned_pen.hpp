// A pen over a canvas that is turned on the screen.
#pragma once

#include "screen/view_transform.hpp"
#include "tools/easel.hpp"

namespace pastoso::view {

/// The pen's lean, rotation and hand, told against the screen, as they are against the canvas. Nothing
/// changes where the canvas is neither turned nor mirrored.
tools::Pointer against_canvas(const screen::ViewTransform& view, tools::Pointer pointer);

}  // namespace pastoso::view

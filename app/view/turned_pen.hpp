// A pen over a canvas that is turned on the screen.
#pragma once

#include "tools/easel.hpp"
#include "view/view_transform.hpp"

namespace pastoso::view {

/// The pen's lean, rotation and hand, told against the screen, as they are against the canvas. Nothing
/// changes where the canvas is neither turned nor mirrored.
tools::Pointer against_canvas(const ViewTransform& view, tools::Pointer pointer);

}  // namespace pastoso::view

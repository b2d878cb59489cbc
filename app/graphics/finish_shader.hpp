// The last step from a picture on the graphics card to the window.
#pragma once

namespace pastoso::graphics {

/// One triangle that covers the viewport.
extern const char* const kCoveringVertexShader;

/// Takes a picture's colours through a cube and dithers.
extern const char* const kFinishShader;

}  // namespace pastoso::graphics

// The last step from the picture of a canvas to the window.
#pragma once

namespace pastoso::screen {

/// Takes the canvas's colours through a cube and dithers.
extern const char* const kFinishShader;

}  // namespace pastoso::screen

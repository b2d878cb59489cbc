// The program that shades the canvas on the graphics card: shade/shading_model.hpp in GLSL 3.30, on the
// same spline surface.
#pragma once

namespace pastoso::view {

/// One triangle that covers the viewport.
extern const char* const kCanvasVertexShader;

/// A pixel of the window: the lit canvas, or the desk around it.
extern const char* const kCanvasFragmentShader;

/// Lines over the picture, their places in millimetres.
extern const char* const kLineVertexShader;
extern const char* const kLineFragmentShader;

}  // namespace pastoso::view

// The program that shades the canvas on the graphics card: shade/shading_model.hpp in GLSL 3.30, on the
// same spline surface.
#pragma once

#include "view/look.hpp"

#include <string>

namespace pastoso::view {

/// One triangle that covers the viewport.
extern const char* const kCanvasVertexShader;

/// A pixel of the window: the canvas, or the ground around it. Every look has a program of its own: on a
/// processor one with branches computes all of them.
std::string canvas_fragment_shader(Look look);

/// Lines over the picture, their places in millimetres.
extern const char* const kLineVertexShader;
extern const char* const kLineFragmentShader;

}  // namespace pastoso::view

// The program that shades the canvas on the graphics card: shade/shading_model.hpp in GLSL 3.30, on the
// same spline surface.
#pragma once

#include "screen/look.hpp"

#include <string>

namespace pastoso::screen {

/// The part of it that knows on which side of an outline a point lies.
extern const char* const kOutlineShader;

/// A pixel of the window: the canvas, or the ground around it. Every look has a program of its own, and
/// one that draws outlines: on a processor one with branches computes all of them.
std::string canvas_fragment_shader(Look look, bool outlined);

/// Lines over the picture, their places in millimetres.
extern const char* const kMovedFragmentShader;
extern const char* const kLineVertexShader;
extern const char* const kLineFragmentShader;

}  // namespace pastoso::screen

// What this display can draw by OpenGL.
#pragma once

#include <string>

namespace pastoso::graphics {

/// Every context from now on is of OpenGL 3.3, and tells when it is lost. Before there is an
/// application.
void ask_for_opengl();

/// Windows from now on have 10 bits a colour where the display has them: on X11, a screen of depth 30.
/// With a QApplication, before the first window.
void ask_for_deep_colour();

/// Whether they have.
bool deep_colour();

struct OpenGlSupport {
    std::string problem{};  ///< why it cannot be used, as one sentence; empty when it can
    std::string renderer{}, vendor{}, version{}, shading_language{};
    int largest_texture = 0;  ///< texels along a side
    bool software = false;    ///< it is the processor that does a card's work
};

/// Looked at once, with a QApplication.
const OpenGlSupport& opengl_support();

}  // namespace pastoso::graphics

// Whether this machine can show the window at all.
#pragma once

#include <optional>
#include <string>

namespace pastoso::main {

/// From now until display_found(), a windowing system that cannot be reached ends the program with exit
/// status 1 and one sentence on the error stream, instead of Qt's abort.
void expect_display();
void display_found();

/// Why OpenGL cannot be used here, as one sentence; nothing when it can. To be called with a
/// QApplication.
std::optional<std::string> opengl_problem();

}  // namespace pastoso::main

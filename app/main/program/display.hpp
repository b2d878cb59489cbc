// Whether this machine can show the window at all.
#pragma once

namespace pastoso::main {

/// From now until display_found(), a windowing system that cannot be reached ends the program with exit
/// status 1 and one sentence on the error stream, instead of Qt's abort.
void expect_display();
void display_found();

}  // namespace pastoso::main

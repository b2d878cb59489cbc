// What the libraries of the engine are linked to, as CMake knows it.
#pragma once

namespace pastoso::tests {

/// A line for each folder of the engine: its name, a colon, and the names of all CMake targets and
/// libraries that a program with its library is linked to ("pastoso_core", "PkgConfig::LIBZIP").
const char* link_closures_text();

}  // namespace pastoso::tests

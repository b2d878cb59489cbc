// What the program runs on: for the painter who asks, and for whoever reads the report of a crash.
#pragma once

#include <utility>
#include <vector>

#include <QString>

namespace pastoso::main {

/// "Graphics card: llvmpipe", and so on: of the program, its libraries, the processor and OpenGL.
std::vector<std::pair<QString, QString>> machine_facts();

}  // namespace pastoso::main

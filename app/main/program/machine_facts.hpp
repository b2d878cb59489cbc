// What the program runs on: for the painter who asks, and for whoever reads the report of a crash.
#pragma once

#include "dialogs/fact_list.hpp"

#include <vector>

namespace pastoso::main {

using Facts = std::vector<dialogs::Fact>;

/// Of the program, its libraries, the processor, the screen and OpenGL.
Facts machine_facts();

}  // namespace pastoso::main

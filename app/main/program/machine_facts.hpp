// What the program runs on: for the painter who asks, and for whoever reads the report of a crash.
#pragma once

#include <utility>
#include <vector>

#include <QString>

namespace pastoso::main {

/// "Processor: 8 at once", and so on.
using Facts = std::vector<std::pair<QString, QString>>;

/// Of the program, its libraries, the processor, the screen and OpenGL.
Facts machine_facts();

/// A line for each.
QString words_of(const Facts& facts);

}  // namespace pastoso::main

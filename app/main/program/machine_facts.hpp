// What the program runs on: for the painter who asks, and for whoever reads the report of a crash.
#pragma once

#include <utility>
#include <vector>

#include <QString>

class QOpenGLWidget;

namespace pastoso::main {

/// "Processor: 8 at once", and so on.
using Facts = std::vector<std::pair<QString, QString>>;

/// Of the program, its libraries, the processor and the screen.
Facts machine_facts();

/// The same, and of OpenGL as `canvas` has it; that there is none while it was not shown yet.
Facts machine_facts(QOpenGLWidget& canvas);

/// A line for each.
QString words_of(const Facts& facts);

}  // namespace pastoso::main

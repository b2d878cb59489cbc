// The version of the program. It stands in the project's CMakeLists.txt and nowhere else.
#pragma once

namespace pastoso::core {

/// "0.1.0".
const char* version();

}  // namespace pastoso::core

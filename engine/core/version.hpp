// The version of the program and its date. They stand in the project's CMakeLists.txt and nowhere else.
#pragma once

namespace pastoso::core {

/// "0.1.0".
const char* version();

/// The day that version() is of, "2026-11-29".
const char* version_date();

}  // namespace pastoso::core

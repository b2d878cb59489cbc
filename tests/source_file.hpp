// Files of the source tree that tests read.
#pragma once

#include <string>

namespace pastoso::tests {

/// The full path of a file of the source tree, given from its top folder: source_file("docs/export.md").
std::string source_file(const std::string& path);

}  // namespace pastoso::tests

// Who may include whom: the tables of ARCHITECTURE.md as a check.
#pragma once

#include "architecture/architecture_page.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace pastoso::tests {

/// One sentence for every #include of a source file that breaks the page's rules. `path` is the file's
/// path in the project, for example "engine/film/solver.cpp"; it decides which rules hold.
std::vector<std::string> include_violations(const ArchitecturePage& page, std::string_view path,
                                            std::string_view text);

}  // namespace pastoso::tests

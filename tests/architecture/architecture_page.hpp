// The tables of ARCHITECTURE.md: the folders of the project, the libraries of others, and who may use
// them.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace pastoso::tests {

using Folders = std::set<std::string, std::less<>>;

struct FolderRow {
    std::string path;  ///< "engine/film"; headers are named from its last part, "film/state.hpp"
    char level = '-';  ///< 0 to 9 in the engine, a to z above it; - is beside them
    Folders named;     ///< what the row names
    Folders may_use;   ///< those, and what they name in turn
    long line = 0;     ///< of the page
};

struct LibraryRow {
    std::string name;                  ///< "LittleCMS"
    std::vector<std::string> headers;  ///< as includes name them; a * stands for any letters
    Folders known_to;
    long line = 0;
};

struct ArchitecturePage {
    std::map<std::string, FolderRow, std::less<>> folders;  ///< by the last part of their path
    std::vector<LibraryRow> libraries;
};

/// Reads the page's text. Throws InputError that names the line: of a row that cannot be read, that
/// comes twice, that names a folder without a row, or a folder that does not lie on a lower level.
ArchitecturePage read_architecture_page(std::string_view text);

/// One sentence for each row whose folder is not among those `present` ("engine/film"), and for each of
/// those that has no row.
std::vector<std::string> folder_violations(const ArchitecturePage& page,
                                           const std::vector<std::string>& present);

}  // namespace pastoso::tests

#include "architecture/include_rules.hpp"

#include <regex>
#include <sstream>

namespace pastoso::tests {
namespace {

struct Include {
    int line;
    bool quoted;  ///< "name", not <name>
    std::string name;
};

std::vector<Include> includes_of(std::string_view text) {
    static const std::regex kInclude("\\s*#\\s*include\\s*([\"<])([^\">]+)[\">].*");
    std::vector<Include> includes;
    std::istringstream lines{std::string(text)};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::smatch match;
        if (std::regex_match(line, match, kInclude))
            includes.push_back({number, match[1] == "\"", match[2]});
    }
    return includes;
}

/// The folder that a source file of the project lies in; none when it lies in none that has a row.
const FolderRow* folder_of(const ArchitecturePage& page, std::string_view path) {
    for (const auto& [name, row] : page.folders)
        if (path.starts_with(row.path + "/")) return &row;
    return nullptr;
}

/// Whether the pattern, in which a * stands for any letters, is the name.
bool matches(std::string_view pattern, std::string_view name) {
    const std::size_t star = pattern.find('*');
    if (star == std::string_view::npos) return pattern == name;
    const std::string_view before = pattern.substr(0, star), after = pattern.substr(star + 1);
    return name.size() + 1 >= pattern.size() && name.starts_with(before) && name.ends_with(after);
}

const LibraryRow* library_of(const ArchitecturePage& page, std::string_view header) {
    for (const LibraryRow& library : page.libraries)
        for (const std::string& pattern : library.headers)
            if (matches(pattern, header)) return &library;
    return nullptr;
}

/// Headers of C++ have names without a dot: <vector>.
bool is_cpp(const Include& include) {
    return !include.quoted && include.name.find_first_of("./") == std::string::npos;
}

/// Why a file of the folder may not include the name; empty when it may.
std::string objection(const ArchitecturePage& page, const std::string& folder, const FolderRow& row,
                      const Include& include) {
    if (const LibraryRow* library = library_of(page, include.name)) {
        return library->known_to.contains(folder) ? "" : folder + " may not know " + library->name;
    }
    if (is_cpp(include) || include.name.ends_with(".moc")) return "";
    if (!include.quoted) return "no library of ARCHITECTURE.md has such a header";
    const std::size_t slash = include.name.find('/');
    if (slash == std::string::npos) return "the project's headers are named with their folder";
    const std::string used = include.name.substr(0, slash);
    return used == folder || row.may_use.contains(used) ? "" : folder + " may not use " + used;
}

}  // namespace

std::vector<std::string> include_violations(const ArchitecturePage& page, std::string_view path,
                                            std::string_view text) {
    const FolderRow* row = folder_of(page, path);
    if (row == nullptr)
        return {std::string(path) + ": lies in no folder that ARCHITECTURE.md has a row for"};
    const std::string folder = row->path.substr(row->path.find('/') + 1);
    std::vector<std::string> violations;
    for (const Include& include : includes_of(text)) {
        const std::string reason = objection(page, folder, *row, include);
        if (reason.empty()) continue;
        violations.push_back(std::string(path) + ":" + std::to_string(include.line) + ": includes " +
                             include.name + ", but " + reason);
    }
    return violations;
}

}  // namespace pastoso::tests

#include "architecture/architecture_page.hpp"

#include "architecture/page_table.hpp"
#include "core/error.hpp"

#include <algorithm>

namespace pastoso::tests {
namespace {

const std::string kPage = "ARCHITECTURE.md";
constexpr std::string_view kAllOf = "all of ", kBut = " but ";

using Rows = decltype(ArchitecturePage::folders);

std::string last_part(const std::string& path) {
    return path.substr(path.find('/') + 1);
}

std::string unquoted(const std::string& word, long line) {
    if (word.size() < 3 || word.front() != '`' || word.back() != '`')
        throw core::located_error(kPage, line, "\"%1\" does not stand between ` and `", word);
    return word.substr(1, word.size() - 2);
}

void add_folder(const std::string& path, const TableRow& row, Rows& folders) {
    if (!path.starts_with("engine/") && !path.starts_with("app/"))
        throw core::located_error(kPage, row.line, "%1 lies neither in engine nor in app", path);
    const std::string& level = row.cells[0];
    if (level.size() != 1) throw core::located_error(kPage, row.line, "\"%1\" is no level", level);
    const FolderRow folder{
        .path = path, .level = level[0], .named = {}, .may_use = {}, .line = row.line};
    const auto [place, is_new] = folders.emplace(last_part(path), folder);
    if (!is_new) {
        throw core::located_error(kPage, row.line, "%1 has the name of %2 in line %3", path,
                                  place->second.path, place->second.line);
    }
}

void expect_row(const Rows& folders, const std::string& name, long line) {
    if (!folders.contains(name))
        throw core::located_error(kPage, line, "%1 has no row in the table", name);
}

/// "engine", "all of app but arguments and cli": the folders of a part.
Folders folders_of_part(std::string_view part, const Rows& folders, long line) {
    Folders left_out;
    if (const std::size_t but = part.find(kBut); but != std::string_view::npos) {
        for (const std::string& name : split(part.substr(but + kBut.size()), " and ")) {
            expect_row(folders, name, line);
            left_out.insert(name);
        }
        part = part.substr(0, but);
    }
    Folders found;
    for (const auto& [name, row] : folders)
        if (row.path.starts_with(std::string(part) + "/") && !left_out.contains(name))
            found.insert(name);
    if (found.empty()) throw core::located_error(kPage, line, "\"%1\" is neither engine nor app", part);
    return found;
}

/// A cell that names folders: "-", "all", or names and whole parts with commas between them.
Folders folders_named(const std::string& cell, const Rows& folders, long line) {
    Folders named;
    if (cell == "-") return named;
    for (const std::string& word : split(cell == "all" ? "engine, app" : cell, ",")) {
        if (word == "engine" || word == "app" || word.starts_with(kAllOf)) {
            const std::string_view part(word);
            named.merge(folders_of_part(word.starts_with(kAllOf) ? part.substr(kAllOf.size()) : part,
                                        folders, line));
            continue;
        }
        expect_row(folders, word, line);
        named.insert(word);
    }
    return named;
}

void expect_lower(const FolderRow& row, const FolderRow& used) {
    if (row.level == '-' || used.level == '-' || used.level < row.level) return;
    throw core::located_error(kPage, row.line, "%1 may not name %2, which is not on a lower level",
                              row.path, used.path);
}

void add_reached(const Folders& from, const Rows& folders, Folders& reached) {
    for (const std::string& name : from)
        if (reached.insert(name).second) add_reached(folders.at(name).named, folders, reached);
}

Rows read_folders(std::string_view text) {
    Rows folders;
    const std::vector<TableRow> rows = table_rows(kPage, text, {"level", "folder", "is", "may use"});
    for (const TableRow& row : rows)
        for (const std::string& path : split(row.cells[1], ","))
            add_folder(unquoted(path, row.line), row, folders);
    for (const TableRow& row : rows)
        for (const std::string& path : split(row.cells[1], ",")) {
            const std::string name = last_part(unquoted(path, row.line));
            folders.at(name).named = folders_named(row.cells[3], folders, row.line);
            // "All of app" in a row of the app.
            folders.at(name).named.erase(name);
        }
    for (auto& [name, row] : folders) {
        for (const std::string& used : row.named)
            expect_lower(row, folders.at(used));
        add_reached(row.named, folders, row.may_use);
        if (row.may_use.contains(name))
            throw core::located_error(kPage, row.line, "%1 uses itself, by way of what it names",
                                      row.path);
    }
    return folders;
}

}  // namespace

ArchitecturePage read_architecture_page(std::string_view text) {
    ArchitecturePage page{.folders = read_folders(text), .libraries = {}};
    for (const TableRow& row : table_rows(kPage, text, {"library", "headers", "known to"})) {
        LibraryRow library{.name = row.cells[0],
                           .headers = {},
                           .known_to = folders_named(row.cells[2], page.folders, row.line),
                           .line = row.line};
        for (const std::string& header : split(row.cells[1], ","))
            library.headers.push_back(unquoted(header, row.line));
        page.libraries.push_back(library);
    }
    return page;
}

std::vector<std::string> folder_violations(const ArchitecturePage& page,
                                           const std::vector<std::string>& present) {
    std::vector<std::string> violations;
    for (const auto& [name, row] : page.folders) {
        if (std::find(present.begin(), present.end(), row.path) != present.end()) continue;
        violations.push_back(
            core::located_error(kPage, row.line, "there is no folder %1", row.path).what());
    }
    for (const std::string& path : present) {
        const auto row = page.folders.find(last_part(path));
        if (row != page.folders.end() && row->second.path == path) continue;
        violations.push_back(path + ": the folder has no row in the table of " + kPage);
    }
    return violations;
}

}  // namespace pastoso::tests

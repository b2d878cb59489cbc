#include "architecture/page_table.hpp"

#include "core/error.hpp"

#include <sstream>

namespace pastoso::tests {
namespace {

std::string trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return "";
    return std::string(text.substr(first, text.find_last_not_of(" \t\r") + 1 - first));
}

bool is_row(const std::string& line) {
    return line.size() > 1 && line.front() == '|' && line.back() == '|';
}

std::vector<std::string> cells_of(const std::string& line) {
    return split(std::string_view(line).substr(1, line.size() - 2), "|");
}

}  // namespace

std::vector<std::string> split(std::string_view text, std::string_view separator) {
    std::vector<std::string> parts;
    for (std::size_t end = text.find(separator); end != std::string_view::npos;
         end = text.find(separator)) {
        parts.push_back(trimmed(text.substr(0, end)));
        text.remove_prefix(end + separator.size());
    }
    parts.push_back(trimmed(text));
    return parts;
}

std::vector<TableRow> table_rows(const std::string& page, std::string_view text,
                                 const std::vector<std::string>& header) {
    std::vector<TableRow> rows;
    std::istringstream lines{std::string(text)};
    std::string line;
    bool within = false;
    for (long number = 1; std::getline(lines, line); ++number) {
        line = trimmed(line);
        if (!is_row(line)) {
            if (within) break;
            continue;
        }
        const std::vector<std::string> cells = cells_of(line);
        if (!within) {
            within = cells == header;
            continue;
        }
        if (cells.size() != header.size()) {
            throw core::located_error(page, number, "the row has %1 cells, its table %2", cells.size(),
                                      header.size());
        }
        rows.push_back({cells, number});
    }
    if (!within)
        throw core::located_error(page, 0, "there is no table that begins with | %1", header.front());
    // The line of dashes below the header.
    if (!rows.empty()) rows.erase(rows.begin());
    return rows;
}

}  // namespace pastoso::tests

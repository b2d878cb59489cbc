#include "files/format_page.hpp"

#include "core/text_file.hpp"
#include "source_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::files {
namespace {

std::string page_text(const std::string& name) {
    return core::read_text_file(tests::source_file("docs/" + name));
}

/// Cells of a table's row without the spaces around them.
std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    for (std::size_t at = line.find('|'); at + 1 < line.size();) {
        const std::size_t end = line.find('|', at + 1);
        if (end == std::string::npos) break;
        std::string cell = line.substr(at + 1, end - at - 1);
        cell.erase(0, cell.find_first_not_of(' '));
        cell.erase(cell.find_last_not_of(' ') + 1);
        cells.push_back(cell);
        at = end;
    }
    return cells;
}

}  // namespace

std::optional<double> number_of(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0') return std::nullopt;
    return value;
}

/// The table's columns are found by its heads.
std::map<std::string, FormatRow> rows_of_page(const std::string& name) {
    const std::string page = page_text(name);
    std::map<std::string, FormatRow> rows;
    std::map<std::string, std::size_t> columns;
    for (std::size_t at = 0, end = 0; at < page.size(); at = end + 1) {
        end = std::min(page.find('\n', at), page.size());
        const std::vector<std::string> cells = cells_of(page.substr(at, end - at));
        if (cells.empty()) {
            columns.clear();
            continue;
        }
        if (cells[0] == "entry") {
            columns.clear();
            for (std::size_t i = 0; i < cells.size(); ++i)
                columns[cells[i]] = i;
        }
        if (cells[0].front() != '`' || !columns.contains("range")) continue;
        const std::string key = cells[0].substr(1, cells[0].size() - 2);
        EXPECT_FALSE(rows.contains(key)) << key << " stands twice";
        rows[key] = {columns.contains("unit") ? cells.at(columns["unit"]) : "",
                     cells.at(columns["default"]), cells.at(columns["range"])};
    }
    return rows;
}

void expect_range(const FormatRow& row, double least, double most, const std::string& key) {
    const std::size_t to = row.range.find(" to ");
    ASSERT_NE(to, std::string::npos) << key;
    EXPECT_EQ(number_of(row.range.substr(0, to)), least) << key;
    EXPECT_EQ(number_of(row.range.substr(to + 4)), most) << key;
}

std::string example_of_page(const std::string& name) {
    const std::string page = page_text(name), begin = "```json\n";
    const std::size_t from = page.find(begin) + begin.size();
    return page.substr(from, page.find("```", from) - from);
}

}  // namespace pastoso::files

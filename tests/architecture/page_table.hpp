// Tables of a Markdown page.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pastoso::tests {

struct TableRow {
    std::vector<std::string> cells;  ///< without the blanks around them
    long line = 0;                   ///< of the page, from 1
};

/// The rows of the table whose header has these cells. Throws InputError when the page has no such
/// table, or when one of its rows has another number of cells; `page` is its name for the message.
std::vector<TableRow> table_rows(const std::string& page, std::string_view text,
                                 const std::vector<std::string>& header);

/// The parts of `text` between separators, without the blanks around them.
std::vector<std::string> split(std::string_view text, std::string_view separator);

}  // namespace pastoso::tests

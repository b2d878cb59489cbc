#include "film/reference_data.hpp"

#include "core/text_file.hpp"
#include "source_file.hpp"

#include <sstream>

namespace pastoso::film::test {
namespace {

/// Splits a line at its commas, those in double quotes excepted.
std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (const char letter : line) {
        if (letter == '"')
            quoted = !quoted;
        else if (letter == ',' && !quoted)
            cells.emplace_back();
        else if (letter != '\r')
            cells.back() += letter;
    }
    return cells;
}

}  // namespace

std::string reference_path(const std::string& file) {
    return tests::source_file("tests/data/film/" + file);
}

ReferenceRow::ReferenceRow(const std::vector<std::string>& names,
                           const std::vector<std::string>& values) {
    for (std::size_t i = 0; i < names.size() && i < values.size(); ++i)
        values_[names[i]] = values[i];
}

const std::string& ReferenceRow::text(const std::string& name) const {
    return values_.at(name);
}

double ReferenceRow::number(const std::string& name) const {
    return std::stod(text(name));
}

std::vector<ReferenceRow> reference_table(const std::string& file) {
    std::istringstream stream(core::read_text_file(reference_path(file)));
    std::vector<ReferenceRow> rows;
    std::string line;
    std::getline(stream, line);
    const std::vector<std::string> names = split(line);
    while (std::getline(stream, line))
        rows.emplace_back(names, split(line));
    return rows;
}

}  // namespace pastoso::film::test

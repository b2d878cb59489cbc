// The tables of a page that describes a format.
#pragma once

#include <map>
#include <optional>
#include <string>

#include <gtest/gtest.h>

namespace pastoso::files {

struct FormatRow {
    std::string unit, value, range;  ///< value: the default
};

/// The rows of docs/PAGE that name one entry in backticks first, of tables with a column of ranges.
/// Fails where an entry stands twice.
std::map<std::string, FormatRow> rows_of_page(const std::string& page);

/// The whole text as a number.
std::optional<double> number_of(const std::string& text);

void expect_range(const FormatRow& row, double least, double most, const std::string& key);

/// What stands between the page's first "```json" and the next "```".
std::string example_of_page(const std::string& page);

/// Every one of a table of numbers (liquid::tea_numbers()) has a row with its unit, its value in the
/// usual object and its range.
template <class Table, class Object>
void expect_numbers(const std::map<std::string, FormatRow>& rows, const Table& table,
                    const Object& usual) {
    for (const auto& entry : table) {
        ASSERT_TRUE(rows.contains(entry.key)) << entry.key << " is missing";
        const FormatRow& row = rows.at(entry.key);
        EXPECT_EQ(row.unit, entry.unit) << entry.key;
        ASSERT_TRUE(number_of(row.value)) << entry.key;
        // A thirtieth of a second is written with twelve digits.
        EXPECT_NEAR(*number_of(row.value), usual.*entry.value, 1e-11 * usual.*entry.value) << entry.key;
        expect_range(row, entry.least, entry.most, entry.key);
    }
}

}  // namespace pastoso::files

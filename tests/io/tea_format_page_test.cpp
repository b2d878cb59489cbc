// docs/tea-format.md states every number as the program has it.
#include "core/text_file.hpp"
#include "io/json_place.hpp"
#include "io/tea_json.hpp"

#include <cstdlib>
#include <map>
#include <optional>
#include <set>

#include <gmock/gmock.h>

namespace pastoso::io {
namespace {

using liquid::TeaSettings;

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

std::optional<double> number(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0') return std::nullopt;
    return value;
}

struct Row {
    std::string unit, value, range;
};

/// The rows that name one entry in backticks first, with the table's columns found by its heads.
std::map<std::string, Row> rows_of_page() {
    const std::string page = core::read_text_file(PASTOSO_SOURCE_DIR "/docs/tea-format.md");
    std::map<std::string, Row> rows;
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

void expect_range(const Row& row, double least, double most, const std::string& key) {
    const std::size_t to = row.range.find(" to ");
    ASSERT_NE(to, std::string::npos) << key;
    EXPECT_EQ(number(row.range.substr(0, to)), least) << key;
    EXPECT_EQ(number(row.range.substr(to + 4)), most) << key;
}

/// Settings written out, one object.
Json usual() {
    return parse_json(tea_to_json(TeaSettings{}), "usual");
}

TEST(TeaFormatPage, StatesEveryNumberAsTheProgramHasIt) {
    const std::map<std::string, Row> rows = rows_of_page();
    const TeaSettings settings;
    for (const liquid::TeaNumber& entry : liquid::tea_numbers()) {
        ASSERT_TRUE(rows.contains(entry.key)) << entry.key << " is missing";
        const Row& row = rows.at(entry.key);
        EXPECT_EQ(row.unit, entry.unit) << entry.key;
        ASSERT_TRUE(number(row.value)) << entry.key;
        // A thirtieth of a second is written with twelve digits.
        EXPECT_NEAR(*number(row.value), settings.*entry.value, 1e-11 * settings.*entry.value)
            << entry.key;
        expect_range(row, entry.least, entry.most, entry.key);
    }
}

TEST(TeaFormatPage, StatesTheWholeNumbersAsTheProgramHasThem) {
    const std::map<std::string, Row> rows = rows_of_page();
    const Json values = usual();
    const std::map<std::string, std::pair<double, double>> ranges = {
        {"cells", {liquid::kMinTeaCells, liquid::kMaxTeaCells}},
        {"parcels", {1, liquid::kMaxParcels}},
        {"seed", {0, UINT32_MAX}},
        {"ball_candidates", {1, 100000}}};
    for (const auto& [key, range] : ranges) {
        ASSERT_TRUE(rows.contains(key)) << key << " is missing";
        EXPECT_EQ(number(rows.at(key).value), values.at(key).get<double>()) << key;
        expect_range(rows.at(key), range.first, range.second, key);
        // The range is that of the reader.
        const auto read = [&](double value) {
            const auto whole = static_cast<std::int64_t>(value);
            tea_from_json(R"({"format": "pastoso-tea", "version": 1, ")" + key +
                              "\": " + std::to_string(whole) + "}",
                          "page");
        };
        EXPECT_NO_THROW(read(range.first)) << key;
        EXPECT_NO_THROW(read(range.second)) << key;
        EXPECT_THROW(read(range.first - 1), core::InputError) << key;
        EXPECT_THROW(read(range.second + 1), core::InputError) << key;
    }
}

TEST(TeaFormatPage, StatesTheUsualCup) {
    const std::map<std::string, Row> rows = rows_of_page();
    for (const auto& [key, value] : usual().at("cup").items()) {
        ASSERT_TRUE(rows.contains(key)) << key << " is missing";
        ASSERT_TRUE(number(rows.at(key).value)) << key;
        // The cup's numbers have single precision.
        EXPECT_EQ(static_cast<float>(*number(rows.at(key).value)), value.get<float>()) << key;
    }
}

TEST(TeaFormatPage, NamesNothingThatTheProgramDoesNotHave) {
    const Json values = usual();
    std::set<std::string> known;
    for (const auto& [key, value] : values.items())
        known.insert(key);
    for (const auto& [key, value] : values.at("cup").items())
        known.insert(key);
    for (const auto& [key, row] : rows_of_page())
        EXPECT_TRUE(known.contains(key)) << key;
}

TEST(TeaFormatPage, ScenesThatComeWithTheProgramAreListedAndRead) {
    const std::string page = core::read_text_file(PASTOSO_SOURCE_DIR "/docs/tea-format.md");
    ASSERT_FALSE(bundled_tea_names().empty());
    for (const std::string& name : bundled_tea_names()) {
        EXPECT_NO_THROW(read_tea(name)) << name;
        EXPECT_THAT(page, testing::HasSubstr("| `" + name + "` |"));
    }
    EXPECT_EQ(read_tea("usual"), TeaSettings{});
    try {
        read_tea("earl-grey");
        FAIL();
    } catch (const core::InputError& error) {
        EXPECT_STREQ(error.what(),
                     "There is no scene \"earl-grey\"; give a file ending in .json, or one of: "
                     "cold-brew, usual.");
    }
}

}  // namespace
}  // namespace pastoso::io

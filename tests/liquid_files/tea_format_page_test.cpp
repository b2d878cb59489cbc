// docs/tea-format.md states every number as the program has it.
#include "core/text_file.hpp"
#include "files/format_page.hpp"
#include "files/json_place.hpp"
#include "liquid_files/tea_json.hpp"
#include "source_file.hpp"

#include <map>
#include <set>

#include <gmock/gmock.h>

namespace pastoso::liquid_files {
namespace {

using liquid::TeaSettings;

/// Settings written out, one object.
files::Json usual() {
    return files::parse_json(tea_to_json(TeaSettings{}), "usual");
}

TEST(TeaFormatPage, StatesEveryNumberAsTheProgramHasIt) {
    const std::map<std::string, files::FormatRow> rows = files::rows_of_page("tea-format.md");
    files::expect_numbers(rows, liquid::tea_numbers(), TeaSettings{});
}

TEST(TeaFormatPage, StatesTheWholeNumbersAsTheProgramHasThem) {
    const std::map<std::string, files::FormatRow> rows = files::rows_of_page("tea-format.md");
    const files::Json values = usual();
    const std::map<std::string, std::pair<double, double>> ranges = {
        {"cells", {liquid::kMinTeaCells, liquid::kMaxTeaCells}},
        {"parcels", {1, liquid::kMaxParcels}},
        {"seed", {0, UINT32_MAX}},
        {"ball_candidates", {1, 100000}}};
    for (const auto& [key, range] : ranges) {
        ASSERT_TRUE(rows.contains(key)) << key << " is missing";
        EXPECT_EQ(files::number_of(rows.at(key).value), values.at(key).get<double>()) << key;
        files::expect_range(rows.at(key), range.first, range.second, key);
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
    const std::map<std::string, files::FormatRow> rows = files::rows_of_page("tea-format.md");
    for (const auto& [key, value] : usual().at("cup").items()) {
        ASSERT_TRUE(rows.contains(key)) << key << " is missing";
        ASSERT_TRUE(files::number_of(rows.at(key).value)) << key;
        // The cup's numbers have single precision.
        EXPECT_EQ(static_cast<float>(*files::number_of(rows.at(key).value)), value.get<float>()) << key;
    }
}

TEST(TeaFormatPage, NamesNothingThatTheProgramDoesNotHave) {
    const files::Json values = usual();
    std::set<std::string> known;
    for (const auto& [key, value] : values.items())
        known.insert(key);
    for (const auto& [key, value] : values.at("cup").items())
        known.insert(key);
    for (const auto& [key, row] : files::rows_of_page("tea-format.md"))
        EXPECT_TRUE(known.contains(key)) << key;
}

TEST(TeaFormatPage, ScenesThatComeWithTheProgramAreListedAndRead) {
    const std::string page = core::read_text_file(tests::source_file("docs/tea-format.md"));
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
                     "cloud, cold-brew, cream, drops, stirred, usual.");
    }
}

}  // namespace
}  // namespace pastoso::liquid_files

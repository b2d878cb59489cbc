// The rows of the brush editor are those of the preset's table.
#include "panels/pen/preset_rows.hpp"

#include <cmath>
#include <set>
#include <string_view>

#include <gtest/gtest.h>

namespace pastoso::panels {
namespace {

TEST(PresetRows, EveryNumberOfATableStandsOnOnePage) {
    std::set<const brush::PresetField*> seen;
    std::size_t rows = 0;
    for (const PresetPage& page : preset_pages())
        for (const PresetRow& row : page.rows) {
            seen.insert(&field_of(page, row));
            ++rows;
        }
    EXPECT_EQ(seen.size(), brush::preset_fields().size());
    EXPECT_EQ(rows, seen.size()) << "none stands there twice";
}

TEST(PresetRows, ShowWhatTheFieldAllowsAndHaveRoomForIt) {
    for (const PresetPage& page : preset_pages())
        for (const PresetRow& row : page.rows) {
            const ValueRange range = range_of(page, row);
            const brush::PresetField& field = field_of(page, row);
            EXPECT_GE(range.least, row.scale * field.low) << row.key;
            EXPECT_LE(range.most, row.scale * field.high) << row.key;
            const double least_shown = std::round(range.least * std::pow(10.0, row.decimals));
            EXPECT_TRUE(!range.logarithmic || least_shown > 0.0) << row.key;
            EXPECT_TRUE(!field.whole || row.decimals == 0) << row.key;
            if (range.usual) {
                EXPECT_GE(range.usual->least, range.least) << row.key;
                EXPECT_LE(range.usual->most, range.most) << row.key;
            }
        }
}

TEST(PresetRows, SayWhatANumberMeansAndHowFarItGoes) {
    const PresetPage& tip = preset_pages().front();
    EXPECT_EQ(explanation_of(tip, tip.rows.front()).toStdString(), "Width of the tip. From 1 to 200 mm.");
}

}  // namespace
}  // namespace pastoso::panels

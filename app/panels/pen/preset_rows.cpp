#include "panels/pen/preset_rows.hpp"

#include "appearance/shown_names.hpp"
#include "core/check.hpp"
#include "panels/parts/labels.hpp"
#include "tools/hand.hpp"

#include <algorithm>
#include <string_view>

#include <QLocale>

namespace pastoso::panels {
namespace {

using Usual = ValueRange::Usual;

/// What it means, the least and the most, and the unit of both.
constexpr const char* kExplanation = QT_TR_NOOP("%1 From %2 to %3%4.");

constexpr const char* kPercent = QT_TR_NOOP(" %");
constexpr const char* kMillimetres = QT_TR_NOOP(" mm");

constexpr PresetRow kTip[] = {
    {"width", QT_TR_NOOP("Width"), kMillimetres, 1.0, 1, true},
    {"thickness", QT_TR_NOOP("Thickness"), kMillimetres, 1.0, 1, true, Usual{0.1, 60.0}},
    {"length", QT_TR_NOOP("Hair length"), kMillimetres, 1.0, 1, true, Usual{1.0, 100.0}},
    {"point", QT_TR_NOOP("Point"), kMillimetres, 1.0, 1, false, Usual{0.0, 40.0}},
    {"bristles", QT_TR_NOOP("Bristles"), "", 1.0, 0, true, Usual{4.0, 400.0}},
    {"hairs_per_bristle", QT_TR_NOOP("Hairs in each"), "", 1.0, 0},
    {"seed", QT_TR_NOOP("Piece"), "", 1.0, 0, false, Usual{0.0, 200.0}},
    {"tooth", QT_TR_NOOP("Teeth"), kPercent, 100.0},
    {"pores", QT_TR_NOOP("Pores"), kMillimetres, 1.0, 1, false, Usual{0.0, 20.0}},
    {"girth", QT_TR_NOOP("Girth"), kMillimetres, 1.0, 0, false, Usual{0.0, 300.0}}};

constexpr PresetRow kFlex[] = {
    {"bend", QT_TR_NOOP("Bend"), kPercent, 100.0},
    {"splay", QT_TR_NOOP("Splay"), "", 1.0, 2},
    {"lag", QT_TR_NOOP("Trail"), "", 1.0, 2, true},
    {"press_depth", QT_TR_NOOP("Press depth"), "", 1.0, 2},
    {"tilt_gain", QT_TR_NOOP("Lean"), "", 1.0, 2},
    {"descend", QT_TR_NOOP("Into the weave"), "", 1.0, 2, false, Usual{0.0, 2.0}},
    {"rigidity", QT_TR_NOOP("Stiffness"), "", 1.0, 2},
    {"ride", QT_TR_NOOP("Ride"), kPercent, 100.0}};

constexpr PresetRow kPaint[] = {{"film", QT_TR_NOOP("Film"), kMillimetres, 1.0, 3, true},
                                {"run", QT_TR_NOOP("Lasts"), kMillimetres, 1.0, 0, true},
                                {"groove", QT_TR_NOOP("Grooves"), "", 1.0, 2},
                                {"hair", QT_TR_NOOP("Hair streaks"), "", 1.0, 2, false, Usual{0.0, 2.0}},
                                {"streak", QT_TR_NOOP("Uneven load"), kPercent, 100.0},
                                {"gather", QT_TR_NOOP("Gathering"), kPercent, 100.0},
                                {"edge", QT_TR_NOOP("Edges"), "", 1.0, 2},
                                {"start", QT_TR_NOOP("Start"), "", 1.0, 2},
                                {"leave", QT_TR_NOOP("Stays behind"), kPercent, 100.0},
                                {"reach", QT_TR_NOOP("Reach"), "", 1.0, 2, true},
                                {"coat", QT_TR_NOOP("On the grain"), kPercent, 100.0}};

constexpr PresetRow kExchange[] = {{"pickup", QT_TR_NOOP("Pickup"), kPercent, 100.0},
                                   {"mix", QT_TR_NOOP("Mixing"), kPercent, 100.0},
                                   {"wick", QT_TR_NOOP("Wicking"), QT_TR_NOOP(" /mm"), 1.0, 3},
                                   {"momentum", QT_TR_NOOP("Dragging"), kPercent, 100.0},
                                   {"overflow", QT_TR_NOOP("Overflow"), kPercent, 100.0}};

constexpr PresetRow kStroke[] = {{"spacing", QT_TR_NOOP("Step"), "", 1.0, 2},
                                 {"min_spacing", QT_TR_NOOP("Least step"), kMillimetres, 1.0, 2, true},
                                 {"smoothing_ms", QT_TR_NOOP("Smoothing"), QT_TR_NOOP(" ms")},
                                 {"string_mm", QT_TR_NOOP("String"), kMillimetres, 1.0, 1}};

constexpr PresetRow kDroplets[] = {
    {"drop", QT_TR_NOOP("Drop"), QT_TR_NOOP(" mm\u00b3"), 1.0, 5, true},
    {"variation", QT_TR_NOOP("Variation"), kPercent, 100.0},
    {"rate", QT_TR_NOOP("Rate"), QT_TR_NOOP(" mm\u00b3/s"), 1.0, 1, false, Usual{0.0, 1000.0}},
    {"touch", QT_TR_NOOP("First drop"), QT_TR_NOOP(" mm\u00b3"), 1.0, 1, false, Usual{0.0, 200.0}},
    {"capacity", QT_TR_NOOP("Bottle"), QT_TR_NOOP(" mm\u00b3"), 1.0, 1, true},
    {"steepness", QT_TR_NOOP("Steepness"), "", 1.0, 2, true},
    {"centring", QT_TR_NOOP("Centring"), "", 1.0, 2},
    {"throw", QT_TR_NOOP("Throw"), QT_TR_NOOP(" s"), 1.0, 2}};

constexpr PresetRow kAir[] = {
    {"pressure", QT_TR_NOOP("Air pressure"), QT_TR_NOOP(" Pa"), 1.0, 0, false, Usual{0.0, 400.0}}};

constexpr PresetPage kPages[] = {{"tip", QT_TR_NOOP("Tip"), kTip},
                                 {"flex", QT_TR_NOOP("Hairs"), kFlex},
                                 {"paint", QT_TR_NOOP("Paint it leaves"), kPaint},
                                 {"exchange", QT_TR_NOOP("Paint it takes"), kExchange},
                                 {"stroke", QT_TR_NOOP("Stroke"), kStroke},
                                 {"droplets", QT_TR_NOOP("Drops"), kDroplets},
                                 {"air", QT_TR_NOOP("Air"), kAir}};

}  // namespace

std::span<const PresetPage> preset_pages() {
    return kPages;
}

const brush::PresetField& field_of(const PresetPage& page, const PresetRow& row) {
    const auto fields = brush::preset_fields();
    const auto found = std::find_if(fields.begin(), fields.end(), [&](const brush::PresetField& field) {
        return field.section == page.section && field.key == row.key;
    });
    PASTOSO_CHECK(found != fields.end());
    return *found;
}

bool is_width(const brush::PresetField& field) {
    return field.section == "tip" && field.key == "width";
}

ValueRange range_of(const PresetPage& page, const PresetRow& row) {
    const brush::PresetField& field = field_of(page, row);
    const double least = is_width(field) ? tools::kSmallestBrush_mm : field.low;
    const double most = is_width(field) ? tools::kLargestBrush_mm : field.high;
    return {row.scale * least,    row.scale * most, row.decimals,
            translated(row.unit), row.logarithmic,  row.usual};
}

QString explanation_of(const PresetPage& page, const PresetRow& row) {
    const ValueRange range = range_of(page, row);
    const auto number = [](double value) {
        return QLocale().toString(value, 'f', QLocale::FloatingPointShortest);
    };
    return translated(kExplanation)
        .arg(appearance::shown_name(field_of(page, row).meaning), number(range.least),
             number(range.most), range.unit);
}

}  // namespace pastoso::panels

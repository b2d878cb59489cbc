// The numbers of a tool as its editor shows them: the pages they stand on, words and units. Ranges and
// meanings are those of brush::preset_fields().
#pragma once

#include "brush/preset_fields.hpp"
#include "panels/parts/value_row.hpp"

#include <optional>
#include <span>

namespace pastoso::panels {

struct PresetRow {
    const char* key;  ///< of the field, within the page's section
    const char* words;
    const char* unit;    ///< with the space before it
    double scale = 1.0;  ///< shown number / number of the preset
    int decimals = 0;
    bool logarithmic = false;
    std::optional<ValueRange::Usual> usual{};  ///< of the shown number, from end to end of the slider
};

struct PresetPage {
    const char* section;  ///< of the fields
    const char* words;
    std::span<const PresetRow> rows;
};

/// Every field stands on one of them, in its order.
std::span<const PresetPage> preset_pages();

const brush::PresetField& field_of(const PresetPage& page, const PresetRow& row);

/// Whether it is how wide the tool is held: with it go the other measures of the tip.
bool is_width(const brush::PresetField& field);

/// Of the shown number: what the field allows, and for a width what a hand can hold.
ValueRange range_of(const PresetPage& page, const PresetRow& row);

/// What the number means, and from where to where it goes.
QString explanation_of(const PresetPage& page, const PresetRow& row);

}  // namespace pastoso::panels

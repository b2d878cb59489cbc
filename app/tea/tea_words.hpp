// The numbers of the tea as the panel shows them: in which group, in which words and units.
#pragma once

#include "liquid/tea_settings.hpp"

#include <span>

namespace pastoso::tea {

struct TeaRow {
    double liquid::TeaSettings::*value;
    const char* words;
    const char* hint;
    const char* unit;  ///< with the space before it
    double scale;      ///< shown = scale times SI
    int decimals;
    double usual_least, usual_most;  ///< as shown
    bool logarithmic = false;
};

struct TeaSection {
    const char* heading;
    std::span<const TeaRow> rows;
};

/// What may change while the glass stands there.
std::span<const TeaSection> tea_sections();

/// What only a new glass can have otherwise.
const TeaRow& poured_milk();

/// Its limits, name in files and unit.
const liquid::TeaNumber& number_of(const TeaRow& row);

}  // namespace pastoso::tea

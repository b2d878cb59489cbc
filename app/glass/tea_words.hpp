// The numbers of the tea as the panel shows them: in which group and how.
#pragma once

#include "glass/panel_parts.hpp"
#include "liquid/tea/tea_settings.hpp"

#include <span>

namespace pastoso::glass {

struct TeaRow {
    double liquid::TeaSettings::*value;
    NumberWords shown;
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

}  // namespace pastoso::glass

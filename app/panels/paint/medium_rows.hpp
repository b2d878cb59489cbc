// The numbers of a paint as a panel shows them: words, units and what each does to the look.
#pragma once

#include "film/medium.hpp"

#include <span>

namespace pastoso::panels {

struct MediumRow {
    const char* name;  ///< of its widgets
    const char* words;
    const char* hint;
    const char* unit;  ///< with the space before it
    double film::Medium::*member;
    double scale;  ///< shown number / number of the medium
    int decimals = 0;
    bool logarithmic = false;
};

struct MediumSection {
    const char* heading;
    std::span<const MediumRow> rows;
};

std::span<const MediumSection> medium_sections();

}  // namespace pastoso::panels

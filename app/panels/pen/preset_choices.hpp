// What of a tool is no number: one of a few, as its editor shows it.
#pragma once

#include "brush/preset.hpp"

#include <span>

namespace pastoso::panels {

struct PresetChoice {
    const char* section;  ///< of the page that it stands on
    const char* name;     ///< of its widget
    const char* words;
    const char* meaning;
    std::span<const char* const> options;  ///< in their words
    bool contact_only;                     ///< the other kinds of tool have it not
    int (*get)(const brush::Preset&);      ///< the option's place
    void (*set)(brush::Preset&, int);
};

std::span<const PresetChoice> preset_choices();

}  // namespace pastoso::panels

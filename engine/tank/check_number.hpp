// Numbers in their ranges.
#pragma once

#include "core/error.hpp"

#include <sstream>
#include <string>

namespace pastoso::tank {

/// Throws InputError "NAME is VALUE, not between LEAST and MOST." Written so that what is no number
/// fails.
inline void check_number(const std::string& name, double value, double least, double most) {
    if (value >= least && value <= most) return;
    std::ostringstream text;
    text << name << " is " << value << ", not between " << least << " and " << most << ".";
    throw core::InputError(text.str());
}

}  // namespace pastoso::tank

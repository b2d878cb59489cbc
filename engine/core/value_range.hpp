// Numbers that a user gives, and the range they must lie in.
#pragma once

#include "core/message.hpp"

#include <string_view>

namespace pastoso::core {

/// Throws InputError "NAME is VALUE, not between LEAST and MOST." unless least <= value <= most. What is
/// no number lies in no range.
void check_range(std::string_view name, double value, double least, double most);
/// The same of what has no name in files and is called so.
void check_range_of(Pattern<0> what, double value, double least, double most);

}  // namespace pastoso::core

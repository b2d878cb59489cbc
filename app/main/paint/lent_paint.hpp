// Whether the paint is the painter's to use.
#pragma once

#include "main/studio.hpp"

namespace pastoso::main {

/// Whether a recording that is being played has it; says so then.
bool paint_is_lent(Studio& studio);

}  // namespace pastoso::main

// Drops at rest, held and drawing back: what contact angles do.
#pragma once

#include "film/validation/case.hpp"

namespace pastoso::film::validation {

Case resting_drop();
Case held_drop();
Case retracting_strip();

}  // namespace pastoso::film::validation

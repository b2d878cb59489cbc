// Paint that runs, spreads and levels.
#pragma once

#include "film/validation/case.hpp"

namespace pastoso::film::validation {

Case nusselt_film();
Case bingham_film();
Case herschel_bulkley_film();

Case slope_current();
Case round_current();

Case gravity_ripple();
Case tension_ripple();
Case running_wave();

Case yielded_heap();
Case yielded_slope();
Case kept_marks();

Case running_drop();
Case fingers();

Case tension_front();

}  // namespace pastoso::film::validation

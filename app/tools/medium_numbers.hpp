// The numbers of a paint as a painter turns them.
#pragma once

#include "film/medium.hpp"

namespace pastoso::tools {

/// The medium with one of its numbers changed, clamped to its range. Numbers that must not contradict
/// it go along: the receding angle stays below the advancing one, alpha_min below alpha_max, and paint
/// that dries too slowly for its thickness dries as slowly as it may.
film::Medium with_number(film::Medium medium, double film::Medium::*member, double value);

/// The range of a number.
const film::MediumNumber& number_of(double film::Medium::*member);

}  // namespace pastoso::tools

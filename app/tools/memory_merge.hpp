// What two windows remember of the same things, put together.
#pragma once

#include "files/json_place.hpp"

namespace pastoso::tools {

/// What `mine` has changed since `before`, in `theirs`, which others have written meanwhile; where both
/// have changed the same, mine. Objects are put together entry by entry, and so are lists of words and
/// of objects with a "name", each element by what it is called: mine in their order, then what is new
/// in theirs. Null stands for what is not there.
files::Json merged(const files::Json& before, const files::Json& mine, const files::Json& theirs);

}  // namespace pastoso::tools

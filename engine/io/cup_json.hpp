// A cup in a JSON object (docs/tea-format.md).
#pragma once

#include "io/json_place.hpp"
#include "liquid/tea/cup.hpp"

namespace pastoso::io {

/// What the object does not say is as usual. Ranges are left to whoever knows what the cup is for.
liquid::Cup read_cup(const JsonPlace& place);

/// read_cup() gives it back exactly.
Json cup_to_json(const liquid::Cup& cup);

}  // namespace pastoso::io

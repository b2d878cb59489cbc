// A cup in a JSON object (docs/tea-format.md).
#pragma once

#include "files/json_place.hpp"
#include "liquid/vessel/cup.hpp"

namespace pastoso::liquid_files {

/// What the object does not say is as usual. Ranges are left to whoever knows what the cup is for.
liquid::Cup read_cup(const files::JsonPlace& place);

/// read_cup() gives it back exactly.
files::Json cup_to_json(const liquid::Cup& cup);

}  // namespace pastoso::liquid_files

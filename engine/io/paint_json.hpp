// Mixtures of paints in JSON files.
#pragma once

#include "document/events.hpp"
#include "io/json_place.hpp"

namespace pastoso::io {

/// {"mix": [["PB29", 62], ["PW6", 38]], "strength": 0.4}; the strength only where it is not 1.
Json paint_json(const document::PaintRecipe& paint);

/// Reads the same; neither names nor numbers are checked (document::check_paint()).
document::PaintRecipe read_paint(const JsonPlace& place);

}  // namespace pastoso::io

// Mixtures of paints, and media by their numbers, in JSON files.
#pragma once

#include "document/events.hpp"
#include "film/medium.hpp"
#include "io/json_place.hpp"

#include <string_view>

namespace pastoso::io {

/// {"mix": [["PB29", 62], ["PW6", 38]], "strength": 0.4}; the strength only where it is not 1.
Json paint_json(const document::PaintRecipe& paint);

/// Reads the same; neither names nor numbers are checked (document::check_paint()).
document::PaintRecipe read_paint(const JsonPlace& place);

/// A medium from an object with any of the numbers of film::medium_numbers(); those left out are as in
/// `like`. `skipped` are keys that mean something else.
film::Medium read_medium_numbers(const JsonPlace& place, const film::Medium& like,
                                 std::string_view skipped = {});

}  // namespace pastoso::io

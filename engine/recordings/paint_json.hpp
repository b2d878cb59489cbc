// Mixtures of paints, and media by their numbers, in JSON files.
#pragma once

#include "document/paint_recipe.hpp"
#include "files/json_place.hpp"
#include "film/medium.hpp"

#include <string_view>

namespace pastoso::recordings {

/// {"mix": [["PB29", 62], ["PW6", 38]], "strength": 0.4}; the strength only where it is not 1.
files::Json paint_json(const document::PaintRecipe& paint);

/// Reads the same; neither names nor numbers are checked (document::check_paint()).
document::PaintRecipe read_paint(const files::JsonPlace& place);

/// A medium from an object with any of the numbers of film::medium_numbers(); those left out are as in
/// `like`. `skipped` are keys that mean something else.
film::Medium read_medium_numbers(const files::JsonPlace& place, const film::Medium& like,
                                 std::string_view skipped = {});

}  // namespace pastoso::recordings

// What painters call a mixture of paints, in their language.
#pragma once

#include "document/events.hpp"

#include <QString>

namespace pastoso::panels {

/// "8 Titanium white + 1 Ultramarine blue"
QString recipe_words(const document::PaintRecipe& paint);

/// "PB29 62 %, PW6 38 %", "PB29" alone, and ", thinned to 40 %" behind it where there is medium in it.
QString share_words(const document::PaintRecipe& paint);

}  // namespace pastoso::panels

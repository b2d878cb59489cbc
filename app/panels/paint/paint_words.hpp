// What painters call a mixture of paints, in their language.
#pragma once

#include "document/events.hpp"
#include "pigment/hiding.hpp"
#include "tools/paint_share.hpp"

#include <QString>

namespace pastoso::panels {

/// "8 Titanium white + 1 Ultramarine blue"
QString recipe_words(const document::PaintRecipe& paint);

/// "semi-transparent"
QString hiding_words(pigment::Hiding hiding);

/// "Ultramarine blue, transparent"; clear medium is that alone.
QString paint_words(const document::PaintRecipe& paint, pigment::Hiding hiding);

/// "PB29 62 %, PW6 38 %", "PB29" alone, and ", thinned to 40 %" behind it where there is medium in it.
QString share_words(const document::PaintRecipe& paint);

/// "milk, 30 %": what thinned paint is like, and how much of it is paint.
QString thinning_words(tools::Body body, double paint_share);

/// One tube a line, its parts in front; below them in which shares the pigments are in it.
QString recipe_lines(const document::PaintRecipe& paint);

/// "close", of a difference in CIEDE2000.
QString difference_words(double difference);

}  // namespace pastoso::panels
